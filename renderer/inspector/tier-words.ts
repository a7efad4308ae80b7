import type { DeviceRow } from '../../export/program/devices/device-table.ts';

const TIERS: Readonly<Record<DeviceRow['tier'], string>> = {
  'ar-camera': 'AR with camera access',
  ar: 'AR',
  camera: 'Camera, no AR',
  'authored-vr': 'VR',
  orbit: 'Orbit view',
};

/** How a page plays on a kind of device, in words. */
export function tierWords(tier: DeviceRow['tier']): string {
  return TIERS[tier];
}
