"""What the module is made of: service, case, scene (no Slicer) and nodes (MRML)."""
