import { own } from '../../export/graph/own.ts';
import { type AppCommandId, appCommand, appCommandIds } from './app-commands.ts';
import type { Editor } from './editor.ts';

/** The keys of a command, as the person has them; menus show the first. */
export function chordsOf({ preferences }: Pick<Editor, 'preferences'>, id: AppCommandId): readonly string[] {
  return own(preferences.getState().chords, id) ?? appCommand(id).chords;
}

/**
 * The command of a chord; with a text field focused, only those that no text field has a use for. Timeline and preview have keys
 * of their own, which go before the others there and are none elsewhere.
 */
export function commandOfChord(
  editor: Pick<Editor, 'preferences'>,
  chord: string,
  typing: boolean,
  where: 'canvas' | 'time' = 'canvas',
): AppCommandId | null {
  const fits = (id: AppCommandId) => {
    const { byEvent, whileTyping } = appCommand(id);
    return chordsOf(editor, id).includes(chord) && byEvent !== true && (!typing || whileTyping === true);
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

/** What has the chord now, other than the command that it is for. */
export function ownerOfChord(editor: Pick<Editor, 'preferences'>, chord: string, except: AppCommandId): AppCommandId | null {
  const same = (id: AppCommandId) => id !== except && isOfTime(id) === isOfTime(except);
  return appCommandIds().find((id) => same(id) && chordsOf(editor, id).includes(chord)) ?? null;
}

function isOfTime(id: AppCommandId): boolean {
  return appCommand(id).where === 'time';
}

/** Gives a command one chord in place of those it has; another command that had it goes without. Null takes all away. */
export function bindChord(editor: Pick<Editor, 'preferences'>, id: AppCommandId, chord: string | null): void {
  const loser = chord === null ? null : ownerOfChord(editor, chord, id);
  const taken = loser === null ? {} : { [loser]: chordsOf(editor, loser).filter((other) => other !== chord) };
  editor.preferences.setState(({ chords }) => ({ chords: { ...chords, ...taken, [id]: chord === null ? [] : [chord] } }));
}

export function resetChords({ preferences }: Pick<Editor, 'preferences'>): void {
  preferences.setState({ chords: {} });
}
