"""Line records to ink: found, drawn on a canvas, laid over the app's picture."""
