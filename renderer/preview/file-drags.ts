import type { FromPreview } from '../preview-protocol.ts';

/** Tells the editor of files that are dragged over the page, and of those that are dropped. Otherwise the browser would open a dropped file. */
export function watchFileDrags(page: Window, send: (message: FromPreview) => void): void {
  const onDrag = (event: DragEvent) => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = 'copy';
    send({ kind: 'file-drag' });
  };
  const onDrop = (event: DragEvent) => {
    event.preventDefault();
    const items = [...(event.dataTransfer?.items ?? [])].filter(({ kind }) => kind === 'file');
    const isFolder = (item: DataTransferItem) => item.webkitGetAsEntry()?.isDirectory === true;
    const files = items.flatMap((item) => (isFolder(item) ? [] : (item.getAsFile() ?? [])));
    const [x, y] = [event.clientX / page.innerWidth, event.clientY / page.innerHeight];
    send({ kind: 'dropped', files, hasFolder: items.some(isFolder), x, y });
  };
  page.addEventListener('dragenter', onDrag);
  page.addEventListener('dragover', onDrag);
  page.addEventListener('drop', onDrop);
}
