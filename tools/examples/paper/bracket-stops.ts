/** Exposures of the two photographs of `bracket.ts`, in stops from that of the studio. */
export const BRACKET = { long: 1.5, short: -3 } as const;
