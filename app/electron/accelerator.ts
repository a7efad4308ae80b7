/** Keys that Electron has other names for, or that it has at all besides single characters (its documentation, “Accelerator”). */
const NAMED: Readonly<Record<string, string>> = {
  ArrowUp: 'Up',
  ArrowDown: 'Down',
  ArrowLeft: 'Left',
  ArrowRight: 'Right',
  '+': 'Plus',
  ...Object.fromEntries(
    ['Space', 'Tab', 'Backspace', 'Delete', 'Insert', 'Enter', 'Home', 'End', 'PageUp', 'PageDown'].map((key) => [key, key]),
  ),
};

/** `Mod+Shift+Z` of the editor as Electron writes it; null where it has no name for it, or macOS would take text for it. */
export function acceleratorOf(keybinding: string, platform: NodeJS.Platform): string | null {
  // The last key may itself be a plus.
  const cut = keybinding.slice(0, -1).lastIndexOf('+');
  const modifiers = cut < 0 ? [] : keybinding.slice(0, cut).split('+');
  const key = keybinding.slice(cut + 1);
  const known = NAMED[key] ?? (/^([!-~]|F([1-9]|1[0-9]|2[0-4]))$/.test(key) ? key : null);
  if (known === null) return null;
  const types = !modifiers.includes('Mod') && !/^F\d/.test(key);
  if (platform === 'darwin' && types) return null;
  return [...modifiers.map((modifier) => (modifier === 'Mod' ? 'CmdOrCtrl' : modifier)), known].join('+');
}
