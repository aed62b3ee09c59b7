"""Which lines there are in a layer, joined into chains. Outputs use it; it knows none of them.

What an output asks, in order:

* `groups.grouped`: what a styler gave (`glshim.styling.lines.Lines`) as groups of one lens and
  look;
* `finder.LineFinder.records`: the lines of a group, (L, 21) in eye space
  (`glshim.model.lines.Line` names the columns), hidden ones among them;
* `chains.chained`: which of them join end to end, and their points in eye space or in the window.

Intersections (`intersections`) are computed here from pairs of triangles, which an output names:
the OpenGL output sees them in the depth of what is drawn.
"""
