"""Files of a build: parts, STL, STEP, 3MF, scene, order list, manifest."""
