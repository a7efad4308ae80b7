import { getOwn } from '../../../export/graph/record.ts';
import type { Editor } from '../editor/editor.ts';
import { type AppCommandId, appCommand, appCommandIds } from './app-commands.ts';

/** The keys of a command, as the person has them; menus show the first. */
export function keybindingsOf({ preferences }: Pick<Editor, 'preferences'>, id: AppCommandId): readonly string[] {
  return getOwn(preferences.getState().keybindings, id) ?? appCommand(id).keys;
}

/**
 * The command of a keybinding; with a text field focused, only those that no text field has a use for. Timeline and preview have keys
 * of their own, which go before the others there and are none elsewhere.
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

/** Whether a person may give a command other keys: the browser's own copy and paste have theirs. */
export function isRebindable(id: AppCommandId): boolean {
  return appCommand(id).byEvent !== true;
}

/** What has the keybinding now, other than the command that it is for. */
export function ownerOfKeybinding(editor: Pick<Editor, 'preferences'>, keybinding: string, except: AppCommandId): AppCommandId | null {
  const same = (id: AppCommandId) => id !== except && isOfTime(id) === isOfTime(except);
  return appCommandIds().find((id) => same(id) && keybindingsOf(editor, id).includes(keybinding)) ?? null;
}

function isOfTime(id: AppCommandId): boolean {
  return appCommand(id).where === 'time';
}

/** Gives a command one keybinding in place of those it has; another command that had it goes without. Null takes all away. */
export function setKeybinding(editor: Pick<Editor, 'preferences'>, id: AppCommandId, keybinding: string | null): void {
  const loser = keybinding === null ? null : ownerOfKeybinding(editor, keybinding, id);
  const taken = loser === null ? {} : { [loser]: keybindingsOf(editor, loser).filter((other) => other !== keybinding) };
  editor.preferences.setState(({ keybindings }) => ({
    keybindings: { ...keybindings, ...taken, [id]: keybinding === null ? [] : [keybinding] },
  }));
}

export function resetKeybindings({ preferences }: Pick<Editor, 'preferences'>): void {
  preferences.setState({ keybindings: {} });
}
