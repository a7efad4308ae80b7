/** The most that the captures and splats of a page take together of the GPU of a phone or headset. */
export const PHONE_GPU_BYTES = 128e6;

/**
 * Divides memory among assets. Assets that need less than an equal part get what they need, and the others divide the rest equally. What all
 * of them leave is divided equally, too, so that one asset alone gets everything.
 *
 * @param needs What each asset takes without a limit, bytes.
 * @returns The limit of each asset, whole bytes.
 *
 * @example
 * memoryShares([10e6, 200e6, 90e6], 128e6); // [10e6, 59e6, 59e6]
 */
export function memoryShares(needs: readonly number[], limitBytes: number): readonly number[] {
  const shares = needs.map(() => 0);
  const ascending = needs.map((_, i) => i).sort((a, b) => (needs[a] ?? 0) - (needs[b] ?? 0) || a - b);
  let left = limitBytes;
  for (const [done, index] of ascending.entries()) {
    const share = Math.min(needs[index] ?? 0, left / (needs.length - done));
    shares[index] = share;
    left -= share;
  }
  return shares.map((share) => Math.floor(share + left / needs.length));
}
