import type { DiagnosticCode } from '../../nodes/kit/diagnostics.ts';

/** What to do about each diagnostic, in general; the message itself names the place. A code without advice does not compile. */
export const ADVICE: Readonly<Record<DiagnosticCode, string>> = {
  SCR001:
    'Open the file at the line that the message names and mend the JSON; a missing comma, quote or bracket is usual, and so is a merge mark.',
  SCR002: 'Open the file at the place that the message names and give the key the shape it asks for, or take back the last edit by hand.',
  SCR003: 'Update Scrim, or open an older copy of the project.',
  SCR004: 'Check that the folder holds a `project.scrim.json` and that you may read it.',
  SCR005: 'Make the file smaller: shrink the picture or simplify the model, and take generated text out of shaders.',
  SCR006: 'Replace the value by a finite number; JSON has no NaN or Infinity, and numbers beyond 1.8e308 become one.',
  SCR010: 'Check the spelling of the type, add the missing shader to the project’s `shaders` folder, or delete the node.',
  SCR011: 'Update Scrim, or place the node anew with this version.',
  SCR012: 'Delete the wire and draw it again; the node or port it names was renamed or removed.',
  SCR013: 'Connect ports of the same colour and shape, or put a node between them that turns one type into the other.',
  SCR014: 'Remove one of the wires named; a picture can only depend on itself through a node that delays by one frame.',
  SCR015: 'Connect the port that the message names.',
  SCR016: 'Keep one of the wires and delete the others, or merge them first with a node that takes several.',
  SCR017: 'Place a Screen and wire the finished layer to it; delete any second one.',
  SCR018: 'Choose a value that the inspector offers; the file may have been edited by hand or saved by another version.',
  SCR019: 'Bind the param to a value, or choose one that can change while the picture runs: those have a port.',
  SCR020: 'Choose another subgraph, or break the circle of subgraphs that contain each other.',
  SCR021: 'Wire the node towards the screen, or delete it; it costs nothing as it is.',
  SCR022:
    'Mend the expression at the character that the message names. What can be written is in the description of the node “Expression”.',
  SCR023: 'Let fewer lights cast shadows, or remove lights that the message says do nothing.',
  SCR024: 'Choose “Shadow map” as the method of the shadow, or use a model whose shape is in its triangles.',
  SCR025:
    'The device has its limits: a largest picture, or none of 32-bit floats. Shadows are drawn as well as it can; choose a smaller resolution or “Soft” edges, so that all devices show the same.',
  SCR030: 'Import the file into the project, or choose another in the inspector.',
  SCR031: 'Copy the file into the project’s `assets` folder and choose it from there.',
  SCR032: 'Open the file in the program that made it and save it again: pictures as PNG, JPEG or WebP, models as glTF 2.0 (.glb).',
  SCR033: 'Choose a file of the kind that the param asks for.',
  SCR034:
    'Reduce its triangles or its textures in the program that made it; the message says which of them and how far. It works as it is, but slowly on phones, or not on all.',
  SCR035:
    'Close its holes in a 3D program, where visitors can see into them: what a phantom hides, and its shadows, show through. Models that stand for nothing real are not judged.',
  SCR036:
    'Nothing has to be done: the page has the model as it is. Saving it again from the program that made it often lets it be compressed.',
  SCR040: 'Mend the JSON in the shader’s first comment at the line that the message names.',
  SCR041: 'Mend the line that the message names; until then the last version that worked goes on running.',
  SCR042: 'Mend the line that the message names: the graphics driver refused it; until then the last version that worked goes on running.',
  SCR043: 'Take the input out of the shader’s header, or live without it: Scrim has nothing to feed it with yet.',
  SCR044:
    'Look at the loop that the message names: its condition may never fail, or a param may make it go round too often. Previews and checks allow 16,384 rounds a pixel; exported pages have no limit. Loops whose text says how often they go round, such as `for (int i = 0; i < 20000; i++)`, are drawn up to 262,144 rounds a pixel, with a warning.',
  SCR045:
    'Paste every tab whole, with a line such as `// Buffer A` before each and `// iChannel0: Buffer A` below it. Sound, cube maps and the keyboard have no counterpart: mend the converted file by hand.',
  SCR046:
    'Ask the author of the work for other terms, use another work, or publish the page for no business. Works under “NC” licences may be shown, with their credit, where no money is made.',
  SCR047:
    'The picture is shown without the effect. Load the page again; where the browser starts no workers, as under a policy of the site that forbids them, leave the effect out. If it is an effect of your own, the message has the words of the error in its `worker.ts`.',
  SCR050: 'Open the page in a browser with WebXR, such as Chrome on an AR phone; elsewhere the page shows the picture without AR.',
  SCR051: 'Allow what the page asks for in the browser’s site settings, and start again.',
  SCR052: 'Start the session again.',
  SCR053: 'Wait for the picture to come back, or reload; if it happens again, lower the resolution or take out the newest effect.',
  SCR054: 'Compare the session folder with `docs/SESSION-FORMAT.md`, or convert the recording again.',
  SCR055: 'Nothing has to be done; to have the full picture, use a device that offers what the message names.',
  SCR056:
    'A node passes on at most 16 pulses per frame; those beyond are lost. Look at what makes so many: a time that is too short, or wires that go around.',
  SCR060: 'Choose a folder that you may write to, or change its permissions.',
  SCR061: 'Choose an empty or new folder, or one that Scrim exported to before; nothing was changed.',
  SCR062: 'Free some space and try again; the files on disk are as they were.',
  SCR063: 'Save under another name, or load the file from disk; saving over it would lose the other change.',
  SCR064: 'Read the lines that follow the message; a file of the installation may be missing, which `npm ci` brings back.',
  SCR065:
    'The page is whole all the same. In the editor, wait until the preview shows something, then export again; on the command line, install Chromium or Chrome, or name its program in `SCRIM_CHROMIUM`.',
  SCR070: 'Run `scrim help` to see the commands and their options.',
  SCR071: 'Install Chromium or Chrome, or name one in the variable `SCRIM_CHROMIUM`.',
  SCR072: 'Check that Scrim is still running in its terminal, start it again and reload the page; unsaved work is offered on opening.',
  SCR073: 'Open the editor through the address that Scrim printed at its start; addresses of an earlier start no longer work.',
  SCR074: 'Save your work under another name and report what you did, with the message.',
};
