import type { DiagnosticCode } from '../../nodes/kit/diagnostics.ts';

/** The general remedy for each diagnostic; the message itself names the place. A code without advice does not compile. */
export const ADVICE: Readonly<Record<DiagnosticCode, string>> = {
  SCR001:
    'Open the file at the line that the message names and fix the JSON. Usual causes are a missing comma, quote or bracket, or a merge conflict marker.',
  SCR002: 'Open the file at the place that the message names and correct the value of the key, or undo the last manual edit.',
  SCR003: 'Update Scrim, or open an older copy of the project.',
  SCR004: 'Check that the folder contains a `project.scrim.json` and that you have permission to read it.',
  SCR005: 'Make the file smaller: scale down the image, simplify the model, or remove generated text from shaders.',
  SCR006: 'Replace the value with a finite number. JSON has no NaN or Infinity; numbers beyond 1.8e308 become infinite.',
  SCR010: 'Check the spelling of the type, add the missing shader to the project’s `shaders` folder, or delete the node.',
  SCR011: 'Update Scrim, or delete the node and add it again with this version.',
  SCR012: 'Delete the wire and connect the ports again; the node or port was renamed or removed.',
  SCR013: 'Connect ports of the same color and shape, or put a node between them that converts one type to the other.',
  SCR014: 'Remove one of the wires named; a cycle must pass through a node that delays by one frame.',
  SCR015: 'Connect the port that the message names.',
  SCR016: 'Keep one of the wires and delete the others, or combine them first with a node that accepts several.',
  SCR017: 'Add one Output node (`output/screen`) and connect the finished layer to it; delete any others.',
  SCR018: 'Choose a value in the inspector. The file may have been edited by hand or saved by another version.',
  SCR019: 'Bind the parameter to a value, or choose a parameter that can change while the program plays: those have a port.',
  SCR020: 'Choose another subgraph, or break the cycle of subgraphs that contain each other.',
  SCR021: 'Connect the node to the output, or delete it; an unconnected node costs nothing.',
  SCR022: 'Fix the expression at the character that the message names. The description of the node “Expression” lists the syntax.',
  SCR023: 'Let fewer lights cast shadows, or remove the lights that the message names as unused.',
  SCR024: 'Choose “Shadow map” as the method of the shadow, or use a model without alpha maps and displacement maps.',
  SCR025:
    'Choose a lower resolution or “Soft” edges, so that all devices show the same shadows. This device limits the texture size or has no 32-bit float textures.',
  SCR026: 'Delete unused nodes, or nest fewer instances of subgraphs. Each instance counts with all its nodes.',
  SCR027: 'Connect everything to one of the two nodes, and delete the other.',
  SCR076:
    'Replace the node, or tell visitors which devices they need. The section “Devices” of the inspector plays the page as each kind of device.',
  SCR028:
    'Use a panorama in which lamps or windows are visible, choose the other method, or add a Directional light. Until then the whole panorama lights the scene.',
  SCR029: 'Export the panorama again from the program that made it, without infinite, negative or undefined numbers.',
  SCR030: 'Import the file into the project, or choose another in the inspector.',
  SCR031: 'Copy the file into the project’s `assets` folder and choose it from there.',
  SCR032: 'Open the file in the program that made it and save it again: images as PNG, JPEG or WebP, models as glTF 2.0 (.glb).',
  SCR033: 'Choose a file of the kind that the parameter needs.',
  SCR034:
    'Reduce its triangles or textures in the program that made it; the message says which and by how much. A model works unchanged, but slowly or not at all on some phones. Captures and splats that need more memory than phones have are reduced there; the message says what they lose.',
  SCR035:
    'Close the holes in a 3D program where visitors can see into them. Hidden objects and shadows show through the holes of a phantom. Other models are not checked.',
  SCR036:
    'No action is needed: the page contains the uncompressed model. To compress it, try to save it again in the program that made it.',
  SCR037:
    'Choose “Box” as the shape if a box is right. Otherwise use a model that is solid and has fewer vertices: flat models, models without volume and models of more than 200,000 vertices have no useful hull.',
  SCR038: 'Connect the output “Body” to the input “Bodies” of a Physics world, or delete the Body node.',
  SCR039:
    'Panoramas are equirectangular (2 : 1), the photo of a mirror ball (1 : 1), or six faces of a cube as a cross (4 : 3, 3 : 4) or a strip (6 : 1, 1 : 6). Crop or extend the picture to one of these shapes. A square picture that is no mirror ball is to be exported again, twice as wide as high.',
  SCR068:
    'Use shots of one panorama, taken from one place, of one size, that differ in exposure only; the darkest shows the lamps, and neighbors are at most about 5 stops apart.',
  SCR069:
    'Compare the folder with `docs/CAPTURE-FORMAT.md`: photographs, cameras and a mesh. Export the cameras again, or leave out the photographs that the message names.',
  SCR040: 'Fix the JSON in the shader’s first comment at the line that the message names.',
  SCR041: 'Fix the line that the message names. Until then the last working version plays.',
  SCR042: 'Fix the line that the message names; the graphics driver rejected it. Until then the last working version plays.',
  SCR043: 'Remove the input from the shader’s header, or ignore this message: Scrim does not support this type of input yet.',
  SCR044:
    'Check the loop that the message names: its condition may never fail, or a parameter may cause too many iterations. Previews and checks allow 16,384 iterations per pixel; exported pages have no limit. Loops with a constant count, such as `for (int i = 0; i < 20000; i++)`, are drawn up to 262,144 iterations per pixel, with a warning.',
  SCR045:
    'Paste each tab completely, with a line such as `// Buffer A` before each and `// iChannel0: Buffer A` below it. Sound, cube maps and the keyboard have no equivalent: edit the converted file by hand.',
  SCR046:
    'Ask the author of the work for other terms, use another work, or publish the page non-commercially. Works under “NC” licenses may be shown with their credit for non-commercial purposes.',
  SCR047:
    'Reload the page. If the browser starts no workers, for example because the site’s policy forbids them, remove the effect. For your own effect, the message contains the error in its `worker.ts`. Until then the layer is shown without the effect.',
  SCR048:
    'Insert a Tone map into the wire of a scene layer that should become a display layer, or “To scene” into the wire of a display layer. The problem list offers both.',
  SCR049: 'Choose a brighter base in Negative shadow, or a greater depth of shadow; use the glasses in a darker room.',
  SCR050: 'Open the page in a browser with WebXR, such as Chrome on an AR phone; other browsers show the page without AR.',
  SCR051: 'Allow the requested features in the browser’s site settings, and start again.',
  SCR052: 'Start the session again.',
  SCR053: 'Wait until the preview recovers, or reload the page. If it happens again, lower the resolution or remove the newest effect.',
  SCR054: 'Compare the session folder with `docs/SESSION-FORMAT.md`, or convert the recording again.',
  SCR055: 'No action is needed. For the complete effect, use a device with the feature that the message names.',
  SCR056:
    'Find the source of the pulses: an interval that is too short, or a cycle of wires. A node passes on at most 16 pulses per frame; the rest is lost.',
  SCR057:
    'Place the objects anew at the next visit, or remove anchors that are no longer needed by a pulse at “Clear”. If the shape of the room is not kept, or cannot be read, look around the room once: it is measured anew.',
  SCR058:
    'If it happens once, no action is needed: a new worker goes on from the last step. If it happens again, reload the page and simulate fewer bodies.',
  SCR059: 'Shorten the text. For characters that the font of Text 3D lacks, use a Label, which draws with the fonts of the browser.',
  SCR060: 'Choose a folder with write permission, or change its permissions.',
  SCR061: 'Choose an empty or new folder, or one of an earlier export; nothing was changed.',
  SCR062: 'Free some disk space and try again; the files on disk are unchanged.',
  SCR063: 'Save under another name, or load the file from disk; overwriting it would lose the other change.',
  SCR064: 'Read the lines that follow the message; if a file of the installation is missing, `npm ci` restores it.',
  SCR065:
    'In the editor, wait until the preview shows an image, then export again. On the command line, install Chromium or Chrome, or set `SCRIM_CHROMIUM` to its path. The page works without a poster.',
  SCR066:
    'A save: wait a minute and save again. If nobody else has the project open, break the lock in the editor. An import of photographs: wait until the other one has ended, or cancel it. An import whose process has ended does not count.',
  SCR067: 'Restore the folder or connect its drive, then save again, or save under another name. Unsaved work is still in the editor.',
  SCR070: 'Run `scrim help` to see the commands and their options.',
  SCR071: 'Install Chromium or Chrome, or set the environment variable `SCRIM_CHROMIUM` to its path.',
  SCR072:
    'Check that Scrim is still running in its terminal. If it is not, start it again and reload the page; it offers to restore unsaved work.',
  SCR073: 'Open the address that Scrim printed when it started; addresses of earlier starts no longer work.',
  SCR074: 'Save your work under another name. Report the message and your last steps.',
  SCR075:
    'Start Scrim again; it offers to restore unsaved work. An address of `scrim open` works once. For a new tab of the same browser, open the editor’s address without the part after `#`.',
  SCR077:
    'Change the style or the occlusion until the figure is better, or change the limit of `scrim score`. The figures of each frame are in the output of `--json`.',
  SCR078:
    'Scrim runs some programs of others where they are installed, such as COLMAP. The message names the place to get it, or the log file with everything that it printed. An option of the command, or an environment variable, names its executable file.',
};
