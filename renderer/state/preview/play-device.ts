import type { DeviceKind } from '../../../export/program/devices/device-facts.ts';
import type { DeviceRow } from '../../../export/program/devices/device-table.ts';
import type { PreviewTier } from '../../preview-protocol.ts';
import { chosenSource, type DeviceFrame, type PreviewState, type PreviewStore } from '../editor/preview-state.ts';

const FRAMES: Readonly<Record<DeviceKind, DeviceFrame>> = {
  'android-phone': 'phone',
  quest: 'headset',
  'android-xr': 'headset',
  'vision-pro': 'headset',
  'see-through': 'glasses',
  iphone: 'phone',
  laptop: 'fill',
};

/**
 * Plays the preview as a kind of device would play the page: an emulated room with the features of the device, else the camera of this
 * computer or the orbit view.
 *
 * @returns Whether there is a source for it.
 */
export function playDevice(preview: PreviewStore, { kind, tier }: Pick<DeviceRow, 'kind' | 'tier'>): boolean {
  const sourceId = tier === 'camera' || tier === 'orbit' ? tier : roomOf(preview.getState());
  if (sourceId === null) return false;
  const frame = FRAMES[kind];
  preview.setState({ sourceId, frame, views: frame === 'headset' ? 2 : 1, tier: previewTier(tier), deviceKind: kind });
  return true;
}

/** The emulated room that the preview shows, or the first. */
function roomOf(state: PreviewState): string | null {
  const chosen = chosenSource(state);
  return chosen?.kind === 'room' ? chosen.id : (state.sources.find(({ kind }) => kind === 'room')?.id ?? null);
}

function previewTier(tier: DeviceRow['tier']): PreviewTier {
  switch (tier) {
    case 'ar-camera':
    case 'ar':
      return tier;
    case 'authored-vr':
      return 'vr';
    case 'camera':
    case 'orbit':
      return 'ar-camera';
  }
}
