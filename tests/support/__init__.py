"""Objects, meshes, recordings and oracles that several tests share."""
