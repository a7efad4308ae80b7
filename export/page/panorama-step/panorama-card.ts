import { element } from '../dom.ts';
import type { PanoramaStorage, StoredPanorama } from './panorama-storage.ts';
import { pictureOf, readPicture } from './picture-file.ts';

export interface PanoramaCardOptions {
  readonly document: Document;
  readonly storage: Pick<PanoramaStorage, 'load'>;
  /** Width to which an equirectangular image from a file is scaled. */
  readonly widthPx: number;
  readonly onUse: (panorama: StoredPanorama) => Promise<void>;
  readonly onForget: () => Promise<void>;
}

/** Creates the part of the start card by which visitors load their panorama from a file, save it to a file, or delete it. */
export function createPanoramaCard({ document, storage, widthPx, onUse, onForget }: PanoramaCardOptions): HTMLElement {
  const status = element(document, 'p', { attributes: { role: 'status' } });
  const input = element(document, 'input', {
    hidden: true,
    attributes: { type: 'file', accept: 'image/*', 'aria-label': 'Panorama file' },
  });
  const button = (label: string, onClick: () => void) =>
    element(document, 'button', { className: 'small', attributes: { type: 'button' }, onClick }, label);
  const save = button('Save as file', () => void saveFile());
  const forget = button('Delete', () => void onForget().then(() => show(null)));
  const show = (panorama: StoredPanorama | null, text?: string): void => {
    status.textContent = text ?? (panorama === null ? NONE : KEPT);
    save.hidden = panorama === null;
    forget.hidden = panorama === null;
  };
  const saveFile = async (): Promise<void> => {
    const panorama = await storage.load();
    const file = panorama && (await pictureOf(document, panorama));
    if (!file) return show(panorama, 'There is no panorama to save.');
    const url = URL.createObjectURL(file);
    element(document, 'a', { attributes: { href: url, download: 'panorama.png' } }).click();
    URL.revokeObjectURL(url);
  };
  let chosen = 0;
  input.addEventListener('change', () => {
    const [file] = input.files ?? [];
    input.value = '';
    if (!file) return;
    chosen++;
    status.textContent = 'Reading the picture…';
    readPicture(document, file, widthPx)
      .then(async (panorama) => {
        await onUse(panorama);
        show(panorama, 'The picture is used. It stays on this device.');
      })
      .catch((error: unknown) => show(null, error instanceof Error ? error.message : String(error)));
  });
  const refresh = async (): Promise<void> => {
    const before = chosen;
    const panorama = await storage.load();
    // What is said of a picture that was chosen meanwhile stays.
    if (chosen === before) show(panorama);
  };
  const card = element(
    document,
    'details',
    { className: 'lacks' },
    element(document, 'summary', {}, 'Panorama of your room'),
    status,
    element(
      document,
      'div',
      { className: 'step-actions' },
      button('Choose a picture…', () => input.click()),
      save,
      forget,
    ),
    input,
  );
  // It may have been taken since.
  card.addEventListener('toggle', () => void refresh());
  show(null);
  return card;
}

const NONE =
  'The page takes a panorama when you enter with a camera. You can also choose a picture of a 360° camera, or one that another device saved here.';
const KEPT = 'A panorama is kept on this device. It is sent nowhere.';
