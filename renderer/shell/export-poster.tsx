import { useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { POSTER_SIZE } from '../../app/contract/poster-size.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { chosenSource, isLoading } from '../state/editor/preview-state.ts';
import { base64Of } from '../state/files/base64.ts';
import { followPreview, frameObjects, keepPoster, nextPoster, roomToShow } from '../state/files/poster.ts';
import { Button } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';

export interface ShownPoster {
  /** JPEG; null while it is being rendered, or if the preview shows nothing. */
  readonly bytes: Uint8Array<ArrayBuffer> | null;
  readonly reading: boolean;
  /** Takes the current image of the preview. */
  readonly take: () => Promise<Uint8Array<ArrayBuffer> | null>;
}

/** Reads the chosen poster, or takes one of the preview, once and again when another is chosen. */
export function usePoster(): ShownPoster {
  const editor = useEditor();
  // The framing and the source of the preview, too, change the poster.
  const page = useDocument(({ project }) => project.page);
  const source = useStore(editor.preview, (state) => (isLoading(state) ? null : (chosenSource(state)?.id ?? null)));
  const [bytes, setBytes] = useState<Uint8Array<ArrayBuffer> | null>(null);
  const [reading, setReading] = useState(true);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another source shows another image
  useEffect(() => {
    let wanted = true;
    setReading(true);
    void nextPoster(editor, page.poster).then((next) => {
      if (!wanted) return;
      setBytes(next);
      setReading(false);
    });
    return () => {
      wanted = false;
    };
  }, [editor, page, source]);
  return { bytes, reading, take: async () => (await editor.posters.take?.(POSTER_SIZE)) ?? null };
}

interface ExportPosterProps {
  readonly poster: ShownPoster;
  /** Whether an export is in progress. */
  readonly busy: boolean;
}

/** The poster that the export will use: an image of the preview, or one that is kept in the project. */
export function ExportPoster({ poster: { bytes, reading, take }, busy }: ExportPosterProps) {
  const editor = useEditor();
  const path = useDocument(({ project }) => project.page.poster);
  const framing = useDocument(({ project }) => project.page.framing);
  const framed = framing !== undefined;
  const room = useStore(editor.preview, (state) => roomToShow(state, framing));
  const frame = () => {
    editor.viewer.setState({ framing: true });
    editor.ui.setState({ dialog: null });
  };
  const picture = useMemo(() => bytes && `data:image/jpeg;base64,${base64Of(bytes)}`, [bytes]);
  return (
    <section className="export-poster" aria-label="Poster" aria-busy={reading}>
      {picture !== null ? (
        <img className="exported-poster" src={picture} alt="Poster of the page" width={1200} height={630} />
      ) : (
        <div className="exported-poster exported-no-poster">
          <Icon name="image" size={24} />
          {reading ? 'Rendering the poster…' : 'The preview shows nothing.'}
        </div>
      )}
      <div className="export-poster-text">
        <h3>Poster</h3>
        <p className="exported-note">
          {path !== undefined
            ? 'Links and the page show the image that is kept in the project.'
            : room
              ? `You framed the room “${room.title}”, but the preview shows another source: this export draws the same part of that one.`
              : framed
                ? 'Links and the page show what you framed, drawn again at each export.'
                : 'Links and the page show the selected objects, or all objects, drawn again at each export.'}
        </p>
        {path === undefined ? (
          <>
            <Button icon="fit" disabled={busy} onPress={frame}>
              Frame in the preview
            </Button>
            <Button disabled={busy || bytes === null} onPress={() => void keepPoster(editor, bytes)}>
              Keep this image
            </Button>
            {room && (
              <Button look="quiet" disabled={busy} onPress={() => editor.preview.setState({ sourceId: room.id })}>
                Preview the room
              </Button>
            )}
            {framed && (
              <Button look="quiet" disabled={busy} onPress={() => frameObjects(editor)}>
                Frame the objects
              </Button>
            )}
          </>
        ) : (
          <>
            <Button disabled={busy} onPress={() => void take().then((next) => keepPoster(editor, next))}>
              Use current image
            </Button>
            <Button look="quiet" disabled={busy} onPress={() => followPreview(editor)}>
              Draw at each export
            </Button>
          </>
        )}
      </div>
    </section>
  );
}
