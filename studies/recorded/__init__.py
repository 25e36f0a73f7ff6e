"""Questions about one recording, each answered once: conventions, the core's interface, cycles, places."""
