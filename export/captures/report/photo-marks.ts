/** Errors are drawn so many times as long as they are. */
const LONGER = 10;

/** What the marks in photographs mean. */
export const MARKS_LEGEND = `Blue: where a point of the reconstruction was seen. Red: towards where the camera projects it, ${LONGER} times as long as the error.`;

/** Marks over a photograph as paths of SVG, in its pixels. */
export interface PhotoMarks {
  /** Where points were seen, as lines without length. */
  readonly seen: string;
  /** Lines towards where the camera projects them. */
  readonly off: string;
}

/** Marks where points were seen and where the camera projects them. `places` are those of a `RecordedView`. */
export function photoMarks(places: readonly number[]): PhotoMarks {
  let [seen, off] = ['', ''];
  for (let i = 0; i < places.length; i += 4) {
    const [x = 0, y = 0, toX = 0, toY = 0] = places.slice(i, i + 4);
    const from = `M${x.toFixed(1)} ${y.toFixed(1)}`;
    seen += `${from}h0`;
    off += `${from}l${(LONGER * (toX - x)).toFixed(1)} ${(LONGER * (toY - y)).toFixed(1)}`;
  }
  return { seen, off };
}
