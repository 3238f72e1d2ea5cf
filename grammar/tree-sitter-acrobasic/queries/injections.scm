((comment) @injection.content
  (#set! injection.language "comment"))

((remark_text) @injection.content
  (#set! injection.language "comment"))
