import { useEffect, useState } from 'react';
import type { AssetKind } from '../../nodes/kit/definition.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { type AssetFacts, NO_FACTS, readAssetFacts } from '../state/files/asset-facts.ts';
import type { AssetRow } from '../state/files/asset-rows.ts';
import { Icon, type IconName } from '../ui/icon.tsx';

const ICONS: Readonly<Record<AssetKind, IconName>> = {
  image: 'image',
  model: 'cube',
  video: 'film',
  audio: 'sound',
  environment: 'sphere',
  capture: 'room',
  splats: 'cube',
};

/** Reads the picture of an asset and its size on the GPU, again when the file has another size. */
export function useAssetFacts({ path, kind, bytes, depthMeshes }: Pick<AssetRow, 'path' | 'kind' | 'bytes' | 'depthMeshes'>): AssetFacts {
  const editor = useEditor();
  const handle = useDocument(({ open }) => open?.handle);
  const assetBaseUrl = useDocument(({ open }) => open?.assetBaseUrl);
  const [facts, setFacts] = useState(NO_FACTS);
  useEffect(() => {
    setFacts(NO_FACTS);
    if (handle === undefined || assetBaseUrl === undefined || bytes === null) return;
    let wanted = true;
    void readAssetFacts(editor, { handle, assetBaseUrl, path, kind, bytes, depthMeshes }).then((read) => {
      if (wanted) setFacts(read);
    });
    return () => {
      wanted = false;
    };
  }, [editor, handle, assetBaseUrl, path, kind, bytes, depthMeshes]);
  return facts;
}

interface AssetPictureProps {
  /** A data URL; null: none is known. */
  readonly picture: string | null;
  readonly kind: AssetKind;
  readonly missing: boolean;
}

/** A small picture of an asset; an icon if there is none. */
export function AssetPicture({ picture, kind, missing }: AssetPictureProps) {
  if (picture !== null && !missing) {
    return <img className="asset-picture" data-kind={kind} src={picture} alt="" width={48} height={36} draggable={false} />;
  }
  return (
    <span className="asset-picture" data-missing={missing}>
      <Icon name={missing ? 'warning' : ICONS[kind]} />
    </span>
  );
}
