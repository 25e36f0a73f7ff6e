"""Files of a build: parts, STL, STEP, 3MF, scene, bill of materials, manifest."""
