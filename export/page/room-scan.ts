import type { SessionEvent } from '../../nodes/kit/session.ts';
import { createControlValues } from './control-values.ts';
import { element } from './dom.ts';
import type { Mounted } from './mount.ts';
import type { Notices } from './notices.ts';
import { createRoomPanel } from './room-panel/room-panel.ts';

export interface RoomScanOptions {
  readonly document: Document;
  readonly notices: Notices;
  readonly mounted: Mounted;
  /** Whether the page is not visible, so that the offer is a panel in the room. */
  readonly hidesPage: boolean;
  readonly capture: Extract<SessionEvent, { readonly kind: 'room-unknown' }>['capture'];
}

/** The topic of the notice with the offer. */
const ROOM_SCAN_TOPIC = 'room';

const TEXTS = {
  unknown: 'The device knows no surface of this room.',
  scan: 'Scan the room',
  later: 'Not now',
  refused: 'The room was not scanned, so its surfaces stay unknown.',
} as const;

export type OfferRoomScan = typeof offerRoomScan;

/** Offers a scan of the room by a button on the page, or on a panel in the room; without `capture` withdraws the offer. */
export function offerRoomScan({ document, notices, mounted, hidesPage, capture }: RoomScanOptions): void {
  const withdraw = (): void => {
    notices.clear(ROOM_SCAN_TOPIC);
    mounted.cover(null);
  };
  if (capture === null) {
    withdraw();
    return;
  }
  const scan = async (): Promise<void> => {
    withdraw();
    if (!(await capture())) notices.show(ROOM_SCAN_TOPIC, { text: TEXTS.refused, tone: 'hint' });
  };
  if (hidesPage) {
    const button = (label: string) => ({ kind: 'button', node: '', param: '', label, value: 0 }) as const;
    const values = createControlValues([button(TEXTS.scan), button(TEXTS.later)], ({ label }) => {
      if (label === TEXTS.scan) void scan();
      else withdraw();
    });
    mounted.cover(createRoomPanel({ gl: mounted.gl, document, title: TEXTS.unknown, values }));
    return;
  }
  const start = element(document, 'button', { className: 'press', attributes: { type: 'button' }, onClick: () => void scan() }, TEXTS.scan);
  notices.show(ROOM_SCAN_TOPIC, { text: TEXTS.unknown, tone: 'hint', action: start });
}
