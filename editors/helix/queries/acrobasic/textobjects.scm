(program) @function.around
(comment) @comment.inside
(comment)+ @comment.around
(remark) @comment.inside
