import { NODE_FILES } from '../../services/file-layer.ts';
import { createProject, DEFAULT_TEMPLATE, findTemplates } from '../../services/templates.ts';
import { type Command, UsageError } from '../command.ts';
import { didYouMean } from '../suggest.ts';

export const newCommand: Command = {
  name: 'new',
  usage: 'NAME [--template T]',
  summary: 'Begin a project',
  doc: 'Makes the project folder NAME, which must be new or empty; its last part becomes the title. What is in it is complete: it can be opened, rendered and exported at once.',
  project: 'required',
  operand: { word: 'NAME', doc: 'the folder of the new project' },
  options: {
    template: {
      type: 'string',
      value: 'T',
      doc: 'What to begin with. empty: the camera’s picture and nothing else, unless given. filter: the camera’s picture as a drawing. occlusion: a model that real things hide, with a shadow on the floor.',
    },
  },
  examples: [
    { line: 'scrim new my-effect', says: 'The camera’s picture, to add anything to.' },
    { line: 'scrim new shows/robot --template occlusion', says: 'A robot in the room, titled “Robot”.' },
  ],
  run: async (call, { installation }) => {
    const template = call.text('template') ?? DEFAULT_TEMPLATE;
    const names = (await findTemplates(installation.templatesDir)).map(({ name }) => name);
    if (!names.includes(template)) {
      const there = `There are ${names.join(', ')}.`;
      throw new UsageError(`There is no template ${JSON.stringify(template)}.${didYouMean(template, names)} ${there}`);
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
