"""Random specifications of every kind of body, built and judged by booleans of triangles."""
