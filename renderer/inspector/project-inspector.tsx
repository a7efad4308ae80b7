import { useId, useState } from 'react';
import { setKeywords, setPage, setTitle } from '../../export/graph/commands/project-info.ts';
import { apply, endGesture } from '../state/document/apply.ts';
import { graphOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { textOfWords, wordsIn } from '../state/recipes/search-words.ts';
import { DevicesSection } from './devices-section.tsx';
import { LibrarySection } from './library-section.tsx';

/** Inspector of the project: title, page description, devices and library. */
export function ProjectInspector() {
  const editor = useEditor();
  const titleId = useId();
  const descriptionId = useId();
  const { title, page, assets } = useDocument((state) => state.project);
  const open = useDocument((state) => state.open !== null);
  const nodeCount = useDocument((state) => Object.keys(graphOf(state).nodes).length);
  if (!open) return <p className="inspector-empty">No project is open.</p>;
  const project = () => editor.document.getState().project;
  return (
    <>
      <header className="inspector-head">
        <h2>Project</h2>
        <p className="inspector-kind">
          {nodeCount} {nodeCount === 1 ? 'node' : 'nodes'}, {Object.keys(assets).length}{' '}
          {Object.keys(assets).length === 1 ? 'asset' : 'assets'}
        </p>
      </header>
      <section className="inspector-section" aria-label="Page">
        <div className="stacked">
          <label htmlFor={titleId}>Title</label>
          <input
            id={titleId}
            className="field"
            value={title}
            onChange={(event) => apply(editor, 'Change the title', setTitle(project(), { title: event.target.value }), 'title')}
            onBlur={() => endGesture(editor)}
          />
        </div>
        <div className="stacked">
          <label htmlFor={descriptionId}>Description</label>
          <textarea
            id={descriptionId}
            className="field"
            rows={3}
            placeholder="Shown to visitors and in search results"
            value={page.description}
            onChange={(event) =>
              apply(editor, 'Change the description', setPage(project(), { page: { description: event.target.value } }), 'description')
            }
            onBlur={() => endGesture(editor)}
          />
        </div>
        <SearchWords />
      </section>
      <DevicesSection />
      <LibrarySection />
      <section className="inspector-section" aria-label="Hint">
        <p className="inspector-note">Select a node to change its parameters. Hold Shift to select several.</p>
      </section>
    </>
  );
}

/** Words by which the palette finds the recipe that is open. Other projects have none. */
function SearchWords() {
  const editor = useEditor();
  const id = useId();
  const [typed, setTyped] = useState('');
  const keywords = useDocument((state) => state.project.recipe?.keywords);
  if (keywords === undefined) return null;
  return (
    <div className="stacked">
      <label htmlFor={id}>Search words</label>
      <input
        id={id}
        className="field"
        placeholder="Separated by commas"
        value={textOfWords(keywords, typed)}
        onChange={({ target }) => {
          setTyped(target.value);
          const change = setKeywords(editor.document.getState().project, { keywords: wordsIn(target.value) });
          apply(editor, 'Change the search words', change, 'keywords');
        }}
        onBlur={() => endGesture(editor)}
      />
    </div>
  );
}
