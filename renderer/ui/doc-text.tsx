import type { ReactNode } from 'react';
import './doc-text.css';

/** Renders the Markdown of definition docs: paragraphs, lists with `-`, `code`, *emphasis*, **strong**; links as their text. */
export function DocText({ text }: { readonly text: string }) {
  const blocks = text.split(/\n{2,}/).filter((block) => block.trim() !== '');
  return (
    <div className="doc-text">
      {blocks.map((block) => {
        const lines = block.split('\n');
        if (!lines.every((line) => /^\s*- /.test(line))) return <p key={block}>{inline(block)}</p>;
        return (
          <ul key={block}>
            {lines.map((line) => (
              <li key={line}>{inline(line.replace(/^\s*- /, ''))}</li>
            ))}
          </ul>
        );
      })}
    </div>
  );
}

const INLINE = /(`[^`]+`|\*\*[^*]+\*\*|\*[^*\s][^*]*\*|\[[^\]]+\]\([^)]+\))/;

function inline(text: string): ReactNode[] {
  let at = 0;
  return text.split(INLINE).map((part) => {
    const key = at;
    at += part.length;
    if (part.startsWith('`')) return <code key={key}>{part.slice(1, -1)}</code>;
    if (part.startsWith('**')) return <strong key={key}>{part.slice(2, -2)}</strong>;
    if (part.startsWith('*') && part.length > 2) return <em key={key}>{part.slice(1, -1)}</em>;
    if (part.startsWith('[')) return part.slice(1, part.indexOf(']'));
    return part;
  });
}
