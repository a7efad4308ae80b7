import { useEffect } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import type { Toast } from '../state/editor/ui.ts';
import { removeToast } from '../state/editor/ui.ts';
import { IconButton } from '../ui/button.tsx';
import { Icon, type IconName } from '../ui/icon.tsx';
import './toasts.css';

const SHOWN_MS = { info: 5000, success: 5000, warning: 8000, error: 12_000 } as const;
const ICONS: Readonly<Record<Toast['tone'], IconName>> = { info: 'info', success: 'check', warning: 'warning', error: 'error' };

/** Short messages at the bottom, such as errors of the host. */
export function Toasts() {
  const { ui } = useEditor();
  const toasts = useStore(ui, (state) => state.toasts);
  return (
    <div className="toasts" role="log" aria-label="Messages" aria-live="polite">
      {toasts.map((toast) => (
        <ToastView key={toast.id} toast={toast} />
      ))}
    </div>
  );
}

function ToastView({ toast }: { readonly toast: Toast }) {
  const { ui, clock } = useEditor();
  useEffect(() => clock.after(SHOWN_MS[toast.tone], () => removeToast(ui, toast.id)), [clock, ui, toast]);
  return (
    <div className={`toast toast-${toast.tone}`}>
      <Icon name={ICONS[toast.tone]} />
      <div className="toast-text">
        <p>{toast.text}</p>
        {toast.detail !== undefined && <p className="toast-detail">{toast.detail}</p>}
      </div>
      <IconButton icon="close" label="Dismiss" small onPress={() => removeToast(ui, toast.id)} />
    </div>
  );
}
