import { chooseFrame, type DeviceFrame } from '../editor/preview-state.ts';
import { keepCurrentImage } from '../files/poster.ts';
import type { AppCommand } from './app-command.ts';
import { switchRenderSize } from './command-actions.ts';
import { always, isOpen } from './command-conditions.ts';

/** Commands that the preview offers beside its picture, too. */
export const PREVIEW_COMMANDS = {
  'preview.fill': frameCommand('fill', 'Frame: fit to panel', ['no device', 'free', 'size']),
  'preview.phone': frameCommand('phone', 'Frame: phone, portrait', ['mobile', 'smartphone', 'upright']),
  'preview.phone-wide': frameCommand('phone-wide', 'Frame: phone, landscape', ['mobile', 'smartphone', 'wide', 'horizontal']),
  'preview.headset': frameCommand('headset', 'Frame: headset', ['vr', 'quest', 'stereo', 'eyes']),
  'preview.glasses': frameCommand('glasses', 'Frame: glasses', ['additive', 'see-through', 'ar']),
  'preview.safe-areas': {
    label: 'Safe areas of phones',
    keywords: ['notch', 'margins', 'insets'],
    keys: [],
    enabled: isOpen,
    run: ({ preview }) => preview.setState(({ safeAreas }) => ({ safeAreas: !safeAreas })),
  },
  'preview.keep-image': {
    label: 'Use image as poster',
    keywords: ['cover', 'still', 'thumbnail of the page'],
    keys: [],
    enabled: isOpen,
    run: (editor) => void keepCurrentImage(editor),
  },
  'preview.poster': {
    label: 'Frame the poster',
    keywords: ['cover', 'crop', 'still'],
    keys: [],
    enabled: isOpen,
    run: ({ viewer }) => viewer.setState({ framing: true }),
  },
  'preview.render-size': {
    label: 'Render size',
    keywords: ['resolution', 'quality', 'pixels', '720p', '1080p', '1440p', 'settings', 'preferences'],
    keys: [],
    enabled: always,
    run: switchRenderSize,
  },
} as const satisfies Record<string, AppCommand>;

function frameCommand(frame: DeviceFrame, label: string, keywords: readonly string[]): AppCommand {
  return {
    label,
    keywords: ['device', 'preview', 'screen', ...keywords],
    keys: [],
    enabled: isOpen,
    run: ({ preview }) => chooseFrame(preview, frame),
  };
}
