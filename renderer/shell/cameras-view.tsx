import { type PointerEvent, useMemo, useState } from 'react';
import { ballAround, camerasPicture, SIDES, type Side } from '../../export/captures/report/cameras-picture.ts';
import type { CaptureReport } from '../../export/captures/report/capture-report.ts';
import { Button } from '../ui/button.tsx';
import { Slider } from '../ui/slider.tsx';

const DEG_PER_RAD = 180 / Math.PI;
/** Turn per pixel of a drag. */
const RAD_PER_PX = 0.01;
const START: Side = SIDES[2] ?? { yawRad: 0, pitchRad: 0 };

interface CamerasViewProps {
  readonly report: Pick<CaptureReport, 'surface' | 'views'>;
  /** Names of the photographs, in the order of the capture. */
  readonly names: readonly string[];
  /** Index of the chosen camera. */
  readonly chosen: number;
  readonly onChoose: (index: number) => void;
}

/** The cameras of a capture over its mesh. Drags turn it, presses choose a camera; the sliders and the list of photographs do so by keys. */
export function CamerasView({ report: { surface, views }, names, chosen, onChoose }: CamerasViewProps) {
  const [side, setSide] = useState(START);
  const ball = useMemo(() => ballAround(surface, views), [surface, views]);
  const { viewBox, mesh, cameras } = useMemo(() => camerasPicture(side, surface, views, ball), [side, surface, views, ball]);
  // Pointers may move several times before the next render.
  const turn = (to: (side: Side) => Side) =>
    setSide((now) => {
      const { yawRad, pitchRad } = to(now);
      return { yawRad: Math.atan2(Math.sin(yawRad), Math.cos(yawRad)), pitchRad: Math.min(Math.max(pitchRad, -Math.PI / 2), Math.PI / 2) };
    });
  const onPointerDown = (event: PointerEvent<SVGSVGElement>) => {
    event.currentTarget.setPointerCapture(event.pointerId);
    const camera = (event.target as Element).getAttribute('data-camera');
    if (camera !== null) onChoose(Number(camera));
  };
  const onPointerMove = ({ currentTarget, pointerId, movementX, movementY }: PointerEvent<SVGSVGElement>) => {
    if (!currentTarget.hasPointerCapture(pointerId)) return;
    turn(({ yawRad, pitchRad }) => ({ yawRad: yawRad + movementX * RAD_PER_PX, pitchRad: pitchRad + movementY * RAD_PER_PX }));
  };
  return (
    <section className="cameras-view" aria-label="Cameras over the mesh">
      <svg viewBox={viewBox} role="img" aria-label="Cameras over the mesh" onPointerDown={onPointerDown} onPointerMove={onPointerMove}>
        <path className="cameras-mesh" d={mesh} />
        {cameras.map((d, i) => (
          <path key={names[i]} className="cameras-camera" d={d} data-camera={i} data-chosen={i === chosen}>
            <title>{names[i]}</title>
          </path>
        ))}
        <path className="cameras-camera" d={cameras[chosen]} data-chosen="true" data-camera={chosen} />
      </svg>
      <div className="cameras-sides">
        {SIDES.map(({ caption, ...each }) => (
          <Button key={caption} onPress={() => setSide(each)}>
            {caption}
          </Button>
        ))}
      </div>
      <Angle label="Turn" mostDeg={180} rad={side.yawRad} onEdit={(yawRad) => turn((now) => ({ ...now, yawRad }))} />
      <Angle label="Tilt" mostDeg={90} rad={side.pitchRad} onEdit={(pitchRad) => turn((now) => ({ ...now, pitchRad }))} />
    </section>
  );
}

interface AngleProps {
  readonly label: string;
  readonly mostDeg: number;
  readonly rad: number;
  readonly onEdit: (rad: number) => void;
}

function Angle({ label, mostDeg, rad, onEdit }: AngleProps) {
  const deg = Math.round(rad * DEG_PER_RAD);
  return (
    <div className="cameras-angle">
      <span aria-hidden="true">{label}</span>
      <Slider
        label={label}
        min={-mostDeg}
        max={mostDeg}
        step={1}
        value={deg}
        valueText={`${deg}°`}
        onEdit={(edited) => onEdit(edited / DEG_PER_RAD)}
        onEnd={() => {}}
      />
      <output>{deg}°</output>
    </div>
  );
}
