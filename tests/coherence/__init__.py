"""How still a drawing stays while its objects move: ``python -m tests.coherence``.

subjects: what is drawn, as bodies with exact matrices. motions: where each frame puts them. carry:
where every pixel of a frame is in another one. measures: what of a picture is not carried along.
patterns and turning are closer looks at textures along contours and at slowly turning meshes.
"""
