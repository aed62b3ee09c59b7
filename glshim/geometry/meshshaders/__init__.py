"""What mesh shaders decide, in numpy: poses, sieves, feature tests."""
