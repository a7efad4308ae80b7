/** Drawn for Scrim on a grid of 16: strokes of 1.4, round ends. */
const PATHS = {
  add: 'M8 3v10M3 8h10',
  close: 'M4 4l8 8M12 4l-8 8',
  check: 'M3 8.500l3.500 3.500L13 4.500',
  chevron: 'M6 4l4 4-4 4',
  undo: 'M3 6.500h6.500a3.500 3.500 0 0 1 0 7H6M3 6.500l3-3M3 6.500l3 3',
  redo: 'M13 6.500H6.500a3.500 3.500 0 0 0 0 7H10M13 6.500l-3-3M13 6.500l-3 3',
  play: 'M5 3.200v9.600l8-4.800z',
  pause: 'M5.500 3.500v9M10.500 3.500v9',
  step: 'M4 3.500v9l6-4.500zM12.500 3.500v9',
  'step-back': 'M12 3.500v9L6 8zM3.500 3.500v9',
  first: 'M3 3v10M13 3.500v9L8 8zM8 3.500v9L3.500 8z',
  last: 'M13 3v10M3 3.500v9L8 8zM8 3.500v9L12.500 8z',
  'mark-in': 'M9.500 3H6v10h3.500',
  'mark-out': 'M6.500 3H10v10H6.500',
  loop: 'M10.500 2.500l2 2-2 2M12.500 4.500h-6a3.500 3.500 0 0 0-3.500 3.500M5.500 13.500l-2-2 2-2M3.500 11.500h6A3.500 3.500 0 0 0 13 8',
  reset: 'M3 3.500v3.500h3.500M3.300 7A5.200 5.200 0 1 1 3 9.500',
  search: 'M7 11.500a4.500 4.500 0 1 0 0-9 4.500 4.500 0 0 0 0 9zM10.500 10.500L14 14',
  folder: 'M2 4.500a1 1 0 0 1 1-1h3l1.500 1.500H13a1 1 0 0 1 1 1v6a1 1 0 0 1-1 1H3a1 1 0 0 1-1-1z',
  export: 'M8 10V2.500M5 5l3-3 3 3M3 9v3.500a1 1 0 0 0 1 1h8a1 1 0 0 0 1-1V9',
  error: 'M8 14A6 6 0 1 0 8 2a6 6 0 0 0 0 12zM8 5v3.500M8 11v.1',
  warning: 'M8 2.500l6 11H2zM8 6.500v3.200M8 11.600v.1',
  info: 'M8 14A6 6 0 1 0 8 2a6 6 0 0 0 0 12zM8 7.500V11M8 5v.1',
  code: 'M5.500 4.500L2 8l3.500 3.500M10.500 4.500L14 8l-3.500 3.500',
  link: 'M6.500 9.500l3-3M7 4.500l1-1a3 3 0 0 1 4.500 4.500l-1 1M9 11.500l-1 1A3 3 0 0 1 3.500 8l1-1',
  up: 'M8 12.500v-9M4.500 7L8 3.500 11.500 7',
  down: 'M8 3.500v9M4.500 9L8 12.500 11.500 9',
  image: 'M3 3h10v10H3zM3 11l3-3 2.500 2.500L10.500 8 13 10.500M6 6v.1',
  fit: 'M3 6V3h3M10 3h3v3M13 10v3h-3M6 13H3v-3',
  eyes: 'M4.800 10.500a2.300 2.300 0 1 0 0-4.600 2.300 2.300 0 0 0 0 4.600zM11.200 10.500a2.300 2.300 0 1 0 0-4.600 2.300 2.300 0 0 0 0 4.600zM7 8h2',
  sun: 'M8 10.500a2.500 2.500 0 1 0 0-5 2.500 2.500 0 0 0 0 5zM8 1.500v1.500M8 13v1.500M1.500 8H3M13 8h1.500M3.400 3.400l1.100 1.100M11.500 11.500l1.100 1.100M3.400 12.600l1.100-1.100M11.500 4.500l1.100-1.100',
  mute: 'M2 8s2.200-4 6-4 6 4 6 4-2.200 4-6 4-6-4-6-4zM3 13L13 3',
  trash: 'M3 4.500h10M6.500 4.500V3h3v1.500M4.500 4.500l.5 8.500h6l.5-8.500M6.800 7v3.800M9.200 7v3.800',
  form: 'M2.500 3.500h4M2.500 8h4M2.500 12.500h4M9.500 2.500h4v2h-4zM9.500 7h4v2h-4zM9.500 11.500h4v2h-4z',
  stop: 'M4.500 4.500h7v7h-7z',
  probe: 'M9.5 3.500l3 3M11 2.500l2.500 2.500-1.500 1.500-2.500-2.500zM10 5L4 11l-.8 2.800L6 13l6-6',
  more: 'M3.500 8v.1M8 8v.1M12.500 8v.1',
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name, size = 16 }: { readonly name: IconName; readonly size?: number }) {
  return (
    <svg
      className="icon"
      width={size}
      height={size}
      viewBox="0 0 16 16"
      fill="none"
      stroke="currentColor"
      strokeWidth={1.4}
      strokeLinecap="round"
      strokeLinejoin="round"
      aria-hidden="true"
      focusable="false"
    >
      <path d={PATHS[name]} />
    </svg>
  );
}
