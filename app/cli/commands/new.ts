import { NODE_FILES } from '../../services/file-layer.ts';
import { createProject, DEFAULT_TEMPLATE, findTemplates } from '../../services/templates.ts';
import { type Command, UsageError } from '../command.ts';
import { didYouMean } from '../suggest.ts';

export const newCommand: Command = {
  name: 'new',
  usage: 'NAME [--template T]',
  summary: 'Create a project',
  doc: 'Creates the project folder NAME, which must be new or empty. The last part of NAME becomes the title. The project is complete: you can open, render and export it.',
  project: 'required',
  operand: { word: 'NAME', doc: 'the folder of the new project' },
  options: {
    template: {
      type: 'string',
      value: 'T',
      doc: 'Template of the project. empty: the camera feed alone (default). filter: the camera feed as a drawing. occlusion: a model that real objects hide, with a shadow on the floor.',
    },
  },
  examples: [
    { line: 'scrim new my-effect', says: 'The camera feed, ready for effects.' },
    { line: 'scrim new shows/robot --template occlusion', says: 'A robot in the room, titled “Robot”.' },
  ],
  run: async (call, { installation }) => {
    const template = call.text('template') ?? DEFAULT_TEMPLATE;
    const names = (await findTemplates(installation.templatesDir)).map(({ name }) => name);
    if (!names.includes(template)) {
      const there = `Templates: ${names.join(', ')}.`;
      throw new UsageError(`Unknown template ${JSON.stringify(template)}.${didYouMean(template, names)} ${there}`);
    }
    const path = call.project;
    const root = await createProject({ templatesDir: installation.templatesDir, template, path, files: NODE_FILES });
    return {
      status: 0,
      json: { ok: true, path: root, template },
      text: `Made ${path} from the template ${template}.\nscrim open ${path} shows it in the editor.`,
      diagnostics: [],
    };
  },
};
