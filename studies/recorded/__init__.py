"""Questions about one recording, each answered once: conventions, interface of the core, loading cycles."""
