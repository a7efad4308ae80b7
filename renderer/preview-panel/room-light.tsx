import { type PointerEvent, useCallback, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { chosenSource, type LightPlace } from '../state/editor/preview-state.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { Popover } from '../ui/popover.tsx';
import { Slider } from '../ui/slider.tsx';
import './room-light.css';

const RAD_PER_DEG = Math.PI / 180;
const LOWEST_DEG = 5;
/** Initial direction: from the front right, 45° up. */
const START: LightPlace = { azimuthRad: Math.PI / 6, elevationRad: Math.PI / 4 };

/** Moves the main light of an emulated room, to test shadows and highlights. */
export function RoomLight() {
  const { preview } = useEditor();
  const isRoom = useStore(preview, (state) => chosenSource(state)?.kind === 'room');
  const light = useStore(preview, (state) => state.roomLight);
  const button = useRef<HTMLSpanElement>(null);
  const [open, setOpen] = useState(false);
  const close = useCallback(() => setOpen(false), []);
  if (!isRoom) return null;
  const place = light ?? START;
  const move = (change: Partial<LightPlace>) => preview.setState({ roomLight: { ...place, ...change } });
  return (
    <>
      <span ref={button}>
        <IconButton icon="sun" label="Room light" pressed={light !== null} onPress={() => setOpen(!open)} />
      </span>
      {open && (
        <Popover label="Room light" from={button} onClose={close}>
          <div className="room-light">
            <Dome place={place} moved={light !== null} onMove={move} />
            <Angle label="Azimuth" minDeg={-180} maxDeg={180} rad={place.azimuthRad} onEdit={(azimuthRad) => move({ azimuthRad })} />
            <Angle
              label="Elevation"
              minDeg={LOWEST_DEG}
              maxDeg={90}
              rad={place.elevationRad}
              onEdit={(elevationRad) => move({ elevationRad })}
            />
            <Button look="quiet" disabled={light === null} onPress={() => preview.setState({ roomLight: null })}>
              Reset
            </Button>
          </div>
        </Popover>
      )}
    </>
  );
}

interface AngleProps {
  readonly label: string;
  readonly minDeg: number;
  readonly maxDeg: number;
  readonly rad: number;
  readonly onEdit: (rad: number) => void;
}

/** Angle slider in whole degrees; `rad` is in radians. */
function Angle({ label, minDeg, maxDeg, rad, onEdit }: AngleProps) {
  const deg = Math.round(rad / RAD_PER_DEG);
  return (
    <div className="room-light-angle">
      <span aria-hidden="true">{label}</span>
      <Slider
        label={label}
        min={minDeg}
        max={maxDeg}
        step={1}
        value={deg}
        valueText={`${deg}°`}
        onEdit={(edited) => onEdit(edited * RAD_PER_DEG)}
        onEnd={() => {}}
      />
      <output>{deg}°</output>
    </div>
  );
}

interface DomeProps {
  readonly place: LightPlace;
  readonly moved: boolean;
  readonly onMove: (place: LightPlace) => void;
}

/** The sky from above: the zenith in the center, the horizon at the rim, the direction of view at the top. The sliders do the same by keys. */
function Dome({ place, moved, onMove }: DomeProps) {
  const radius = 1 - place.elevationRad / (Math.PI / 2);
  const x = radius * Math.sin(place.azimuthRad);
  const y = radius * Math.cos(place.azimuthRad);
  const follow = (event: PointerEvent<HTMLDivElement>) => {
    const box = event.currentTarget.getBoundingClientRect();
    const dx = ((event.clientX - box.left) / box.width) * 2 - 1;
    const dy = ((event.clientY - box.top) / box.height) * 2 - 1;
    const away = Math.min(Math.hypot(dx, dy), 1);
    onMove({ azimuthRad: Math.atan2(dx, dy), elevationRad: Math.max(LOWEST_DEG * RAD_PER_DEG, (1 - away) * (Math.PI / 2)) });
  };
  return (
    <div
      className="room-light-dome"
      aria-hidden="true"
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        follow(event);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) follow(event);
      }}
    >
      <span
        className={moved ? 'room-light-sun' : 'room-light-sun room-light-home'}
        style={{ left: `${(x + 1) * 50}%`, top: `${(y + 1) * 50}%` }}
      />
    </div>
  );
}
