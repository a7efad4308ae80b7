import { useId, useState } from 'react';
import { useEditor } from '../state/editor/editor-context.ts';
import type { ExportedPage } from '../state/editor/ui.ts';
import { readAddress } from '../state/files/export-page.ts';
import { Button } from '../ui/button.tsx';
import { QrCode } from '../ui/qr-code.tsx';

interface PublishedAddressProps {
  readonly exported: ExportedPage;
  readonly busy: boolean;
  /** Exports the page again, with the address. */
  readonly onExport: () => void;
}

/** Where the page is published: its address and a QR code for phones. */
export function PublishedAddress({ exported, busy, onExport }: PublishedAddressProps) {
  const { ui } = useEditor();
  const id = useId();
  const [typed, setTyped] = useState(() => ui.getState().exportSettings.address);
  const address = readAddress(typed);
  const wrong = typed.trim() !== '' && address === null;
  const isNew = address !== null && address !== readAddress(exported.settings.address);
  return (
    <section className="exported-section" aria-labelledby={`${id}-title`}>
      <h3 id={`${id}-title`}>On your web server</h3>
      <div className="published">
        <div className="published-text">
          <label htmlFor={id}>Address of the page</label>
          <input
            id={id}
            className="field"
            type="url"
            inputMode="url"
            spellCheck={false}
            placeholder="https://example.org/my-effect/"
            value={typed}
            aria-invalid={wrong}
            onChange={(event) => {
              setTyped(event.target.value);
              ui.setState(({ exportSettings }) => ({ exportSettings: { ...exportSettings, address: event.target.value } }));
            }}
          />
          <p className="exported-note" role="status">
            {wrong ? 'This is not an address of the web.' : noteOf(address, isNew)}
          </p>
          {isNew && (
            <Button disabled={busy} onPress={onExport}>
              Export again
            </Button>
          )}
        </div>
        {address === null ? <div className="qr-code qr-code-none">QR code</div> : <QrCode text={address} label={`QR code of ${address}`} />}
      </div>
    </section>
  );
}

function noteOf(address: string | null, isNew: boolean): string {
  if (address === null) return 'Upload the folder, then enter its address to get a QR code for phones.';
  return isNew ? 'Link previews find the poster after the next export.' : 'Scan the code with a phone to open the page there.';
}
