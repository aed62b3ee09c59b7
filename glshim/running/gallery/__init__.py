"""``glshim gallery``: one program under many styles, as a page and as a contact sheet."""
