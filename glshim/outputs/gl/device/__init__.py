"""GL objects and state: programs, buffers, textures, framebuffers of ours, and the state guard."""
