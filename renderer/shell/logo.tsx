/** The logo: a half-open curtain. */
export function Logo() {
  return (
    <svg className="logo" width="22" height="22" viewBox="0 0 32 32" fill="none" aria-hidden="true" focusable="false">
      <path d="M6 6h20v4c0 9-3 14-7 16M6 6v21" stroke="var(--accent)" strokeWidth="2.6" strokeLinecap="round" strokeLinejoin="round" />
      <path d="M12.500 6v17M19 6c0 8-1 13-3 17" stroke="var(--accent)" strokeOpacity="0.5" strokeWidth="2.2" strokeLinecap="round" />
    </svg>
  );
}
