import { useEffect, useRef, useState } from 'react';
import type { Photograph } from '../../export/captures/acquire/take-photograph.ts';
import type { PhotographsRequest } from '../preview-protocol.ts';
import { type AcquisitionPlan, reducedCamera } from '../state/acquisition/acquisition-form.ts';
import { type PreviewedCamera, previewCameras } from '../state/acquisition/previewed-camera.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { IconButton } from '../ui/button.tsx';
import { Slider } from '../ui/slider.tsx';

/** Longest side of previewed photographs. */
const PREVIEW_PX = 480;

interface PhotographPreviewProps {
  readonly plan: AcquisitionPlan | null;
  readonly request: PhotographsRequest | null;
  /** Receives the size of the shown photograph as PNG file, per pixel. */
  readonly onPngBytes: (perPixel: number) => void;
}

/** The color and the depth of one camera, and the controls that choose it. */
export function PhotographPreview({ plan, request, onPngBytes }: PhotographPreviewProps) {
  const editor = useEditor();
  const [chosen, setChosen] = useState(0);
  const [shown, setShown] = useState<Photograph | null>(null);
  /** The camera of the photograph that is shown. */
  const [shownPose, setShownPose] = useState<readonly number[] | null>(null);
  const [error, setError] = useState<string | null>(null);
  const [preview, setPreview] = useState<PreviewedCamera | null>(null);
  const color = useRef<HTMLCanvasElement>(null);
  const depth = useRef<HTMLCanvasElement>(null);
  const count = plan?.poses.length ?? 1;
  const index = Math.min(chosen, count - 1);
  const pose = plan?.poses[index];

  useEffect(() => {
    const link = request && editor.renderPage.open?.();
    if (!request || !link) return undefined;
    const page = previewCameras(link, request, {
      onPhotograph: (photograph, worldFromCamera) => {
        setError(null);
        setShownPose(worldFromCamera);
        setShown(photograph);
      },
      onError: setError,
    });
    setPreview(page);
    return () => {
      setPreview(null);
      page.close();
    };
  }, [editor, request]);

  useEffect(() => {
    if (plan && pose) preview?.show(reducedCamera(plan.camera, PREVIEW_PX), pose);
  }, [plan, pose, preview]);

  useEffect(() => {
    if (!shown || !color.current || !depth.current) return undefined;
    const { widthPx, heightPx, pixels } = shown.color;
    draw(color.current, widthPx, heightPx, straight(pixels));
    draw(depth.current, shown.depth.widthPx, shown.depth.heightPx, grays(shown.depth.meters));
    let isCurrent = true;
    color.current.toBlob((png) => {
      if (isCurrent && png) onPngBytes(png.size / (widthPx * heightPx));
    });
    return () => {
      isCurrent = false;
    };
  }, [shown, onPngBytes]);

  const range = shown && rangeOf(shown.depth.meters);
  const name = `camera ${index + 1}`;
  return (
    <div className="photograph-preview" aria-busy={request !== null && error === null && pose !== undefined && shownPose !== pose}>
      <figure>
        <canvas ref={color} role="img" aria-label={`Color of ${name}`} />
        <figcaption>Color</figcaption>
      </figure>
      <figure>
        <canvas ref={depth} role="img" aria-label={`Depth of ${name}`} />
        <figcaption>{depthWords(shown !== null, range)}</figcaption>
      </figure>
      <div className="photograph-steps">
        <IconButton icon="step-back" label="Previous camera" small disabled={index === 0} onPress={() => setChosen(index - 1)} />
        <Slider
          label="Camera"
          value={index + 1}
          min={1}
          max={count}
          step={1}
          valueText={`${index + 1} of ${count}`}
          onEdit={(value) => setChosen(Math.round(value) - 1)}
          onEnd={() => {}}
        />
        <IconButton icon="step" label="Next camera" small disabled={index >= count - 1} onPress={() => setChosen(index + 1)} />
        <span>{`${index + 1} of ${count}`}</span>
      </div>
      {error !== null && (
        <p className="form-error" role="alert">
          {error}
        </p>
      )}
    </div>
  );
}

function depthWords(isShown: boolean, range: readonly [number, number] | null): string {
  if (!isShown) return 'Depth';
  return range === null ? 'Depth: nothing is in view' : `Depth, ${range[0].toFixed(2)} to ${range[1].toFixed(2)} m`;
}

function draw(canvas: HTMLCanvasElement, widthPx: number, heightPx: number, rgba: Uint8ClampedArray<ArrayBuffer>): void {
  canvas.width = widthPx;
  canvas.height = heightPx;
  canvas.getContext('2d')?.putImageData(new ImageData(rgba, widthPx, heightPx), 0, 0);
}

/** RGBA with straight alpha, as `ImageData` has it. */
function straight(premultiplied: Uint8Array): Uint8ClampedArray<ArrayBuffer> {
  const out = new Uint8ClampedArray(premultiplied.length);
  for (let i = 0; i < out.length; i += 4) {
    const alpha = premultiplied[i + 3] ?? 0;
    for (let c = i; c < i + 3; c++) out[c] = alpha > 0 ? (255 * (premultiplied[c] ?? 0)) / alpha : 0;
    out[i + 3] = alpha;
  }
  return out;
}

/** The nearest and the farthest depth; null if nothing has depth. */
function rangeOf(meters: Float32Array): readonly [least: number, most: number] | null {
  let [least, most] = [Infinity, 0];
  for (const m of meters) {
    if (m <= 0) continue;
    least = Math.min(least, m);
    most = Math.max(most, m);
  }
  return most === 0 ? null : [least, most];
}

const DARKEST = 40;

/** What is near is bright, by the inverse of depth; what has no depth is transparent. */
function grays(meters: Float32Array): Uint8ClampedArray<ArrayBuffer> {
  const out = new Uint8ClampedArray(4 * meters.length);
  const [least, most] = rangeOf(meters) ?? [1, 1];
  const span = 1 / least - 1 / most;
  meters.forEach((m, i) => {
    if (m <= 0) return;
    const nearness = span > 0 ? (1 / m - 1 / most) / span : 1;
    out.fill(DARKEST + (255 - DARKEST) * nearness, 4 * i, 4 * i + 3);
    out[4 * i + 3] = 255;
  });
  return out;
}
