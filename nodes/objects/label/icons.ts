/** Side of the square that contains an icon. Icons are outlines as SVG path data, drawn with a line of width `ICON_LINE`. */
export const ICON_SIDE = 24;
export const ICON_LINE = 2;

export const ICONS = {
  info: 'M12 2a10 10 0 1 0 0 20a10 10 0 1 0 0 -20M12 11v6M12 7.2v.6',
  pin: 'M12 22c5 -5.6 7 -9 7 -12.5a7 7 0 1 0 -14 0c0 3.500 2 6.900 7 12.500M12 7a2.500 2.500 0 1 0 0 5a2.500 2.500 0 1 0 0 -5',
  ruler: 'M2 8h20v8h-20zM6 8v4M10 8v3M14 8v4M18 8v3',
  warning: 'M12 3l10 18h-20zM12 10v5M12 17.700v.600',
  check: 'M3 13l6 6l12 -14',
  star: 'M12 2.500l2.900 6.200l6.700 .800l-5 4.600l1.400 6.700l-6 -3.400l-6 3.400l1.400 -6.700l-5 -4.600l6.700 -.800z',
} as const;

export type IconName = keyof typeof ICONS;
