import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { type FrameTimes, timeOfFrame } from '../../nodes/kit/frame-times.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { suggestFolder } from '../state/files/suggest-folder.ts';
import { lastFrame, playedRange } from '../state/preview/playback.ts';
import { type FrameRenderOptions, planFrames, ROOM_RATE_HZ, rateOf, renderFrames } from '../state/preview/render-frames.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { ChoiceField, TextField } from '../ui/form-fields.tsx';
import type { SelectOption } from '../ui/select-field.tsx';
import { DialogErrors } from './dialog-error.tsx';
import { FolderField } from './folder-field.tsx';

const FORMATS: readonly SelectOption<FrameRenderOptions['what']>[] = [
  { value: 'pictures', label: 'Images (PNG)' },
  { value: 'video', label: 'Video' },
];
const RATES = ['24', '25', '30', '50', '60'].map((value) => ({ value, label: value }));
const MOST_PX = 8192;
const SHORT_SIDE_PX = 1080;
const MOST_FRAMES = 100_000;
/** Default range in an emulated room: three seconds. */
const ROOM_RANGE = { from: 0, to: 3 * ROOM_RATE_HZ - 1 };

/** Options of a frame render: range, frame rate, size and format. */
export function RenderDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const { preview } = editor;
  const frames = useStore(preview, (state) => state.frames);
  const id = useId();
  const [what, setWhat] = useState<FrameRenderOptions['what']>('pictures');
  const inRoom = frames === null;
  const [range, setRange] = useState(() => asTexts(inRoom ? ROOM_RANGE : playedRange(preview.getState())));
  const [size, setSize] = useState(() => sizeOf(preview.getState().status));
  const [rate, setRate] = useState(inRoom ? String(ROOM_RATE_HZ) : 'own');
  const [out, setOut] = useState(() => suggestFolder(editor, editor.document.getState().project.title, '-frames'));

  const from = wholeIn(range.from, 0, MOST_FRAMES);
  const to = wholeIn(range.to, from ?? 0, MOST_FRAMES);
  const widthPx = wholeIn(size.width, 1, MOST_PX);
  const heightPx = wholeIn(size.height, 1, MOST_PX);
  const frameRateHz = rate === 'own' ? null : Number(rate);
  const options: FrameRenderOptions | null =
    from === null || to === null || widthPx === null || heightPx === null
      ? null
      : { what, range: { from, to }, widthPx, heightPx, frameRateHz, out: out.trim() };
  return (
    <FormDialog
      title="Render frames"
      action="Render"
      ready={options !== null && (what === 'video' || options.out !== '')}
      onGo={() => void (options && renderFrames(editor, options))}
      onClose={onClose}
      wide
    >
      <ChoiceField label="Format" value={what} options={FORMATS} onChoose={setWhat} />
      <div className="form-row">
        <TextField
          label="First frame"
          text={range.from}
          error={errorOf(from, 0, MOST_FRAMES)}
          onChange={(text) => setRange({ ...range, from: text })}
        />
        <TextField
          label="Last frame"
          text={range.to}
          error={errorOf(to, from ?? 0, MOST_FRAMES)}
          onChange={(text) => setRange({ ...range, to: text })}
        />
        <ChoiceField
          label="Frame rate (fps)"
          value={rate}
          options={[...(frames ? [{ value: 'own', label: `Same as recording (${rateOf(frames)})` }] : []), ...RATES]}
          onChoose={setRate}
        />
      </div>
      <div className="form-row">
        <TextField
          label="Width"
          text={size.width}
          error={errorOf(widthPx, 1, MOST_PX)}
          onChange={(text) => setSize({ ...size, width: text })}
        />
        <TextField
          label="Height"
          text={size.height}
          error={errorOf(heightPx, 1, MOST_PX)}
          onChange={(text) => setSize({ ...size, height: text })}
        />
      </div>
      {what === 'pictures' && (
        <FolderField id={`${id}-folder`} label="Folder" path={out} example="/home/me/frames/my-effect" purpose="render" onChange={setOut} />
      )}
      <p className="dialog-note" role="status">
        {options && `${lengthWords(frames, options)}. `}
        {inRoom && 'Frames show the room from the preview’s current position, as on a phone. '}
        {frames && to !== null && to > lastFrame({ frames }) && 'The recording repeats after its end. '}
        {what === 'video'
          ? 'The video is saved to your downloads, without sound.'
          : 'Choose a new or empty folder, or one with previously rendered frames.'}
      </p>
      {what === 'video' && <DialogErrors />}
    </FormDialog>
  );
}

function lengthWords(frames: FrameTimes | null, { range, frameRateHz }: FrameRenderOptions): string {
  if (frames === null) return countWords(range.to - range.from + 1, (range.to - range.from + 1) / (frameRateHz ?? ROOM_RATE_HZ));
  const count = planFrames(frames, range, frameRateHz, false).filter(({ keep }) => keep).length;
  const lengthS = timeOfFrame(frames, range.to + 1) - timeOfFrame(frames, range.from);
  return countWords(count, lengthS);
}

function countWords(count: number, lengthS: number): string {
  return `${count} ${count === 1 ? 'frame' : 'frames'}, ${lengthS.toFixed(2)} s`;
}

function asTexts({ from, to }: { readonly from: number; readonly to: number }) {
  return { from: String(from), to: String(to) };
}

/** Size of the preview in pixels, or 1280 × 720. */
/** The shape of the preview, at 1080 pixels in the shorter direction. Even, because video encoders require it. */
function sizeOf(status: { readonly widthPx: number; readonly heightPx: number } | null) {
  const { widthPx, heightPx } = status ?? { widthPx: 16, heightPx: 9 };
  const scale = SHORT_SIDE_PX / Math.min(widthPx, heightPx);
  const even = (px: number) => String(2 * Math.round((px * scale) / 2));
  return { width: even(widthPx), height: even(heightPx) };
}

function errorOf(number: number | null, least: number, most: number): string | undefined {
  return number === null ? `Enter a whole number from ${least} to ${most}.` : undefined;
}

function wholeIn(text: string, least: number, most: number): number | null {
  const number = Number(text.trim());
  return text.trim() !== '' && Number.isInteger(number) && number >= least && number <= most ? number : null;
}
