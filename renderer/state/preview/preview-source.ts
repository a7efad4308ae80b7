import { refusedFeatures } from '../../../export/program/devices/device-table.ts';
import type { PreviewSource } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { chosenSource } from '../editor/preview-state.ts';

/** The source of the preview; null if no project is open or the chosen source is not available yet. */
export function previewSource(editor: Pick<Editor, 'document' | 'preview'>): PreviewSource | null {
  const state = editor.preview.getState();
  const { open } = editor.document.getState();
  const source = chosenSource(state);
  if (source === null || open === null) return null;
  const { assetBaseUrl } = open;
  const { still, frame, views, tier, deviceKind } = state;
  switch (source.kind) {
    case 'camera':
    case 'orbit':
      return { kind: source.kind, assetBaseUrl };
    case 'still':
      return still && { kind: 'still', picture: still, key: `${still.name} ${still.size} ${still.lastModified}`, assetBaseUrl };
    case 'room': {
      const device = frame === 'glasses' ? 'glasses' : views === 2 ? 'headset' : 'phone';
      const refuse = [...(deviceKind === null ? [] : refusedFeatures(deviceKind)), ...(tier === 'ar' ? ['camera-access'] : [])];
      return { kind: 'room', captureUrl: source.url, views, device, tier, refuse, assetBaseUrl };
    }
    case 'recorded':
      return source.url === null ? null : { kind: 'recorded', url: source.url, assetBaseUrl };
  }
}
