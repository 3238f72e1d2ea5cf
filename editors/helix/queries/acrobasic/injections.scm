([(comment) (remark_text)] @injection.content
  (#set! injection.language "comment"))
