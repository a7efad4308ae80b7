/** Devices whose first pointer is a finger or a controller, and whose GPUs share their memory with all else. */
const PHONES = '(pointer: coarse)';

/** The memory that an asset has on this device: that of phones and headsets, or no limit. */
export function limitHere(phoneGpuBytes: number | undefined): number | undefined {
  return phoneGpuBytes !== undefined && globalThis.matchMedia(PHONES).matches ? phoneGpuBytes : undefined;
}
