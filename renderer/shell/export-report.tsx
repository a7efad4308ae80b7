import type { ExportedReport } from '../../app/contract/contract.ts';
import { tierWords } from '../inspector/tier-words.ts';
import { withTitles } from '../state/document/message-titles.ts';
import { useDocument } from '../state/editor/editor-context.ts';
import { byteText } from '../state/files/byte-text.ts';
import { Icon, type IconName } from '../ui/icon.tsx';

const PARTS: Readonly<Record<string, string>> = {
  page: 'Page',
  script: 'Scripts',
  style: 'Style',
  offline: 'Offline copy',
  poster: 'Poster',
  program: 'Program',
  decoder: 'Decoders',
  licences: 'Licenses',
  model: 'Models',
  image: 'Images',
  video: 'Videos',
  audio: 'Sounds',
  environment: 'Panoramas',
  capture: 'Captures',
  splats: 'Splats',
};

interface ReportProps {
  readonly report: ExportedReport;
}

/** The size of a page by kind of file, as visitors download it. */
export function ExportSizes({ report: { bytes, parts, files } }: ReportProps) {
  const largest = Math.max(...parts.map(({ gzip }) => gzip));
  return (
    <section className="exported-section" aria-labelledby="exported-size">
      <h3 id="exported-size">Size</h3>
      <p className="exported-total">
        <strong>{byteText(bytes.gzip)}</strong> to download, {byteText(bytes.raw)} on the server,{' '}
        {files === 1 ? '1 file' : `${files} files`}
      </p>
      <ul className="exported-parts">
        {parts.map(({ kind, gzip }) => (
          <li key={kind}>
            <span>{PARTS[kind] ?? kind}</span>
            <span className="exported-bar" style={{ width: `${Math.max(1, (100 * gzip) / largest)}%` }} />
            <span className="exported-bytes">{byteText(gzip)}</span>
          </li>
        ))}
      </ul>
    </section>
  );
}

/** What captures and splats take on the GPU, and what phones and headsets show less of them; nothing if the page has none. */
export function ExportMemory({ report: { assets, gpuBytes } }: ReportProps) {
  const { places } = gpuBytes;
  if (places === null) return null;
  const reduced = assets.flatMap(({ path, reducedOnPhones }) => reducedOnPhones.map((what) => `${path} ${what}.`));
  return (
    <section className="exported-section" aria-labelledby="exported-memory">
      <h3 id="exported-memory">Graphics memory of captures and splats</h3>
      <p className="exported-total">
        <strong>{byteText(places.onPhones)}</strong> of {byteText(places.phoneLimit)} on phones and headsets, {byteText(places.onComputers)}{' '}
        on computers
      </p>
      {reduced.length > 0 && (
        <>
          <p>On phones and headsets:</p>
          <ul>
            {reduced.map((line) => (
              <li key={line} className="exported-note">
                {line}
              </li>
            ))}
          </ul>
        </>
      )}
    </section>
  );
}

/** Stands for the sizes of a page while its form is another than that of the last export. */
export function NoSizes({ busy }: { readonly busy: boolean }) {
  return (
    <section className="exported-section" aria-labelledby="exported-size">
      <h3 id="exported-size">Size</h3>
      <p className="exported-total">{busy ? 'Measuring…' : 'Not exported in this form.'}</p>
    </section>
  );
}

/** What each kind of device shows of a page. */
export function ExportDevices({ report }: ReportProps) {
  return (
    <section className="exported-section" aria-labelledby="exported-devices">
      <h3 id="exported-devices">Devices</h3>
      {report.note !== null && <p className="exported-note">{report.note}</p>}
      <ul className="exported-devices">
        {report.devices.map((row) => (
          <Device key={row.title} row={row} />
        ))}
      </ul>
    </section>
  );
}

type Row = ExportedReport['devices'][number];

function Device({ row }: { readonly row: Row }) {
  const state = useDocument((document) => document);
  const { title, tier, lost, unseen } = row;
  const losses = new Set(
    lost.map(({ node, effect, known }) => `${withTitles(state, node)}: ${known ? effect : `Not known. Perhaps: ${effect}`}`),
  );
  const shadows = unseen.length > 0 ? ['Shadows are invisible.'] : [];
  return (
    <li>
      <Icon name={iconOf(row)} />
      <span>{title}</span>
      <span className="exported-tier">{tierWords(tier)}</span>
      {row.worthless && <span className="exported-loss">A required feature is missing.</span>}
      {[...shadows, ...losses].map((loss) => (
        <span key={loss} className="exported-loss">
          {loss}
        </span>
      ))}
    </li>
  );
}

function iconOf({ worthless, lost, unseen }: Row): IconName {
  if (worthless) return 'error';
  return lost.length + unseen.length > 0 ? 'warning' : 'check';
}
