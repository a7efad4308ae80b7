import { getOwn } from '../../../export/graph/record.ts';
import type { Editor } from '../editor/editor.ts';
import { type AppCommandId, appCommand, appCommandIds } from './app-commands.ts';

/** The current keybindings of a command. Menus show the first. */
export function keybindingsOf({ preferences }: Pick<Editor, 'preferences'>, id: AppCommandId): readonly string[] {
  return getOwn(preferences.getState().keybindings, id) ?? appCommand(id).keys;
}

/**
 * The command of a keybinding; null if there is none. While a text field has the focus (`typing`), only commands with `whileTyping`.
 * Commands of the timeline and the preview take precedence if `where` is `time`; else they have no keys.
 */
export function commandOfKeybinding(
  editor: Pick<Editor, 'preferences'>,
  keybinding: string,
  typing: boolean,
  where: 'canvas' | 'time' = 'canvas',
): AppCommandId | null {
  const fits = (id: AppCommandId) => {
    const { byEvent, whileTyping } = appCommand(id);
    return keybindingsOf(editor, id).includes(keybinding) && byEvent !== true && (!typing || whileTyping === true);
  };
  const found =
    (where === 'time' ? appCommandIds().find((id) => isOfTime(id) && fits(id)) : undefined) ??
    appCommandIds().find((id) => !isOfTime(id) && fits(id));
  return found ?? null;
}

/** Whether a command can have other keys. Copy, cut and paste have those of the browser. */
export function isRebindable(id: AppCommandId): boolean {
  return appCommand(id).byEvent !== true;
}

/** The other command that has the keybinding; null if there is none. */
export function ownerOfKeybinding(editor: Pick<Editor, 'preferences'>, keybinding: string, except: AppCommandId): AppCommandId | null {
  const same = (id: AppCommandId) => id !== except && isOfTime(id) === isOfTime(except);
  return appCommandIds().find((id) => same(id) && keybindingsOf(editor, id).includes(keybinding)) ?? null;
}

function isOfTime(id: AppCommandId): boolean {
  return appCommand(id).where === 'time';
}

/** Replaces the keybindings of a command by one; null removes them. Another command loses the keybinding. */
export function setKeybinding(editor: Pick<Editor, 'preferences'>, id: AppCommandId, keybinding: string | null): void {
  const previousOwner = keybinding === null ? null : ownerOfKeybinding(editor, keybinding, id);
  const taken =
    previousOwner === null ? {} : { [previousOwner]: keybindingsOf(editor, previousOwner).filter((other) => other !== keybinding) };
  editor.preferences.setState(({ keybindings }) => ({
    keybindings: { ...keybindings, ...taken, [id]: keybinding === null ? [] : [keybinding] },
  }));
}

export function resetKeybindings({ preferences }: Pick<Editor, 'preferences'>): void {
  preferences.setState({ keybindings: {} });
}
