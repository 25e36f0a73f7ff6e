"""Questions about one recording, each answered once: places and rest offsets."""
