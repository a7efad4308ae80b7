/* What the pages of reports have in common. */

const STYLE = `
body { font: 14px/1.5 system-ui, sans-serif; margin: 2rem; color: #e6e6e6; background: #14161a; }
table { border-collapse: collapse; margin: 1rem 0; }
th, td { padding: 0.2rem 0.8rem; text-align: right; border-bottom: 1px solid #333; }
th:first-child, td:first-child { text-align: left; }
section { display: flex; flex-wrap: wrap; gap: 0.5rem; }
figure { margin: 0; width: 20rem; }
img { width: 100%; display: block; }`;

/** A page without scripts. `body` is HTML. */
export function page(title: string, body: string, style = ''): string {
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>${text(title)}</title>
<style>${STYLE}${style}</style>
<h1>${text(title)}</h1>
${body}
</html>
`;
}

/** A number with so many digits after the point; a dash if it is none. */
export function fixed(value: number, digits: number): string {
  return Number.isFinite(value) ? value.toFixed(digits) : '–';
}

/** Text as HTML. */
export function text(raw: string): string {
  return raw.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
}
