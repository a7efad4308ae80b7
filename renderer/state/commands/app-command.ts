import type { Editor } from '../editor/editor.ts';

/** An action that a menu, a key or the native menu of the window can start. */
export interface AppCommand {
  readonly label: string;
  /** Further words that the command search finds it by: synonyms and earlier labels. */
  readonly keywords?: readonly string[];
  /** Default keybindings, as `keybindingOf` writes them; `keybindingsOf` gives those that the person set. */
  readonly keys: readonly string[];
  readonly enabled: (editor: Editor) => boolean;
  readonly run: (editor: Editor) => void;
  /** The page's copy and paste events run it, because they need no permission. */
  readonly byEvent?: true;
  /** Runs also while a text field has the focus. */
  readonly whileTyping?: true;
  /** `time`: its keys work only while the timeline or the preview has the focus. */
  readonly where?: 'time';
}
