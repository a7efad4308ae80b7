/** Names of keys in Electron accelerators, besides single characters. */
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

/** Converts a keybinding to an Electron accelerator. Null if Electron has no name for the key, or macOS would treat it as text. */
export function acceleratorOf(keybinding: string, platform: NodeJS.Platform): string | null {
  // The last key may be a plus sign.
  const cut = keybinding.slice(0, -1).lastIndexOf('+');
  const modifiers = cut < 0 ? [] : keybinding.slice(0, cut).split('+');
  const key = keybinding.slice(cut + 1);
  const known = NAMED[key] ?? (/^([!-~]|F([1-9]|1[0-9]|2[0-4]))$/.test(key) ? key : null);
  if (known === null) return null;
  const types = !modifiers.includes('Mod') && !/^F\d/.test(key);
  if (platform === 'darwin' && types) return null;
  return [...modifiers.map((modifier) => (modifier === 'Mod' ? 'CmdOrCtrl' : modifier)), known].join('+');
}
