import { createContext, useContext } from 'react';
import type { PreviewSync } from './preview-sync.ts';

const PreviewSyncContext = createContext<PreviewSync | null>(null);

export const PreviewSyncProvider = PreviewSyncContext.Provider;

export function usePreviewSync(): PreviewSync {
  const previewSync = useContext(PreviewSyncContext);
  if (!previewSync) throw new Error('usePreviewSync must be called below PreviewSyncProvider.');
  return previewSync;
}
