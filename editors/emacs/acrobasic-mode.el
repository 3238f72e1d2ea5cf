;;; acrobasic-mode.el --- AcroBASIC, the language of Parker ACR motion controllers  -*- lexical-binding: t; -*-

;; SPDX-License-Identifier: MIT OR Apache-2.0
;; Version: 0.1.0
;; Package-Requires: ((emacs "28.1"))
;; Keywords: languages

;;; Commentary:

;; Colours, indentation, an index, and the language server `acrc lsp' by way of Eglot.  `M-x eglot' in a program starts it.
;; `acrobasic-lint', `acrobasic-sim' and `acrobasic-mem' run `acrc' in a compilation buffer.

;;; Code:

(require 'acrobasic-words)
(require 'compile)
(require 'project)

(defvar eglot-server-programs)

(defgroup acrobasic nil
  "AcroBASIC, the language of Parker ACR motion controllers."
  :group 'languages)

(defcustom acrobasic-acrc "acrc"
  "The program `acrc', by name or path."
  :type 'string
  :safe #'ignore)

(defcustom acrobasic-indent-offset 4
  "Columns of a step of indentation."
  :type 'natnum
  :safe #'natnump)

;;;; What is a comment, a text, a word

(defvar acrobasic-mode-syntax-table
  (let ((table (make-syntax-table)))
    (dolist (apostrophe '(?\' ?‘ ?’))
      (modify-syntax-entry apostrophe "<" table))
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?\r ">" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?\\ "." table)
    (modify-syntax-entry ?_ "_" table)
    (modify-syntax-entry ?$ "_" table)
    (dolist (sign '(?+ ?- ?* ?/ ?^ ?= ?< ?> ?& ?% ?# ?: ?,))
      (modify-syntax-entry sign "." table))
    table)
  "What the characters of AcroBASIC are.")

(defun acrobasic--inside-p (position)
  "Whether POSITION is inside of a text or a comment."
  (save-excursion (nth 8 (syntax-ppss position))))

(defconst acrobasic--syntax-propertize
  (syntax-propertize-rules
   ;; A remark.
   ("\\(?:^\\|[^[:alpha:]_]\\)\\([Rr]\\)[Ee][Mm]\\(?:[^[:alpha:]_]\\|$\\)"
    (1 (unless (acrobasic--inside-p (match-beginning 1))
         (string-to-syntax "<"))))
   ;; A text that is not closed ends with its line.
   ("\\(\"\\)[^\"\n]*\\(\n\\)"
    (1 (unless (acrobasic--inside-p (match-beginning 1))
         (put-text-property (match-beginning 2) (match-end 2) 'syntax-table (string-to-syntax "|"))
         (string-to-syntax "|"))))
   ;; Closed by itself, so that the rule above takes no text that is.
   ("\\(\"\\)[^\"\n]*\""
    (1 (string-to-syntax "\"")))))

;;;; Colours

(defconst acrobasic--faces
  (let ((faces (make-hash-table :test #'equal)))
    (pcase-dolist (`(,words . ,face)
                   `((,acrobasic-words-daughters . font-lock-type-face)
                     (,acrobasic-words-objects . font-lock-type-face)
                     (,acrobasic-words-commands . font-lock-builtin-face)
                     (,acrobasic-words-functions . font-lock-function-name-face)
                     (,acrobasic-words-operands . font-lock-variable-name-face)
                     (,acrobasic-words-operators . font-lock-keyword-face)
                     (,acrobasic-words-flow . font-lock-keyword-face)))
      (dolist (word words)
        (puthash word face faces)))
    faces)
  "The face of each word.")

(defun acrobasic--match-word (limit)
  "Find the next word of the language before LIMIT.
Numbers may touch it on both sides: `SET34'."
  (let (found)
    (while (and (not found)
                (re-search-forward "\\$?[[:alpha:]]+\\$?" limit t))
      (let ((word (upcase (match-string-no-properties 0)))
            (before (char-before (match-beginning 0)))
            (after (char-after (match-end 0))))
        (setq found (and (gethash word acrobasic--faces)
                         (not (eq before ?_))
                         (not (eq after ?_))))))
    found))

(defun acrobasic--word-face ()
  "The face of the word that was found."
  (gethash (upcase (match-string-no-properties 0)) acrobasic--faces))

(defconst acrobasic--font-lock-keywords
  '(("\\_<_[[:blank:]]*[[:alnum:]_]+" . font-lock-constant-face)
    ("\\_<GO\\(?:TO\\|SUB\\)[[:blank:]]*\\([[:alpha:]][[:alnum:]_]*\\)" 1 font-lock-constant-face)
    ("^[[:blank:]]*\\([0-9]+\\)" 1 font-lock-constant-face)
    ("#[[:blank:]]*DEFINE" . font-lock-preprocessor-face)
    ("#[[:blank:]]*DEFINE[[:blank:]]*\\([[:alpha:]][[:alnum:]_]*\\)" 1 font-lock-variable-name-face)
    (acrobasic--match-word 0 (acrobasic--word-face)))
  "What is coloured besides comments and texts.")

;;;; Indentation

(defun acrobasic--code ()
  "The text of this line without line number, texts and comments, in capitals."
  (save-excursion
    (let ((end (line-end-position)) (parts nil))
      (beginning-of-line)
      (skip-chars-forward " \t0-9")
      (while (< (point) end)
        (let ((start (point)))
          (skip-syntax-forward "^<\"|" end)
          (push (buffer-substring-no-properties start (point)) parts))
        (when (< (point) end)
          ;; A comment reaches to the end, a text to its other quote.
          (if (eq (syntax-class (syntax-after (point))) 11)
              (goto-char end)
            (goto-char (acrobasic--end-of-text end)))))
      (upcase (string-trim (apply #'concat (nreverse parts)))))))

(defun acrobasic--end-of-text (end)
  "The position behind the text that begins at point, at most END."
  (condition-case nil
      (min end (scan-sexps (point) 1))
    (scan-error end)))

(defun acrobasic--begins-p (words code)
  "Whether CODE begins with one of WORDS; letters behind it make another word."
  (let ((case-fold-search nil))
    (string-match-p (concat "\\`" (regexp-opt words t) "\\(?:[^[:alpha:]_]\\|\\'\\)") code)))

(defun acrobasic--opens-p (code)
  "Whether a line with CODE opens a block that it does not close."
  (let ((case-fold-search nil))
    (cond ((acrobasic--begins-p '("IF") code)
           (not (string-match-p "\\(?:\\<\\|)\\)THEN[[:blank:]]*[^[:blank:]]" code)))
          ((acrobasic--begins-p '("FOR") code)
           (not (string-match-p ":[[:blank:]]*NEXT\\(?:[^[:alpha:]]\\|\\'\\)" code)))
          ((acrobasic--begins-p '("WHILE") code)
           (not (string-match-p ":[[:blank:]]*WEND\\(?:[^[:alpha:]]\\|\\'\\)" code)))
          (t (acrobasic--begins-p '("ELSE" "ELSEIF") code)))))

(defun acrobasic--indentation ()
  "The column at which this line should begin."
  (let ((code (acrobasic--code)))
    (if (acrobasic--begins-p '("PROGRAM" "ENDP") code)
        0
      (save-excursion
        (beginning-of-line)
        (skip-chars-backward " \t\r\n")
        (if (bobp)
            0
          (let ((before (acrobasic--code)))
            (max 0 (+ (current-indentation)
                      (if (acrobasic--opens-p before) acrobasic-indent-offset 0)
                      (if (acrobasic--begins-p '("ELSE" "ELSEIF" "ENDIF" "NEXT" "WEND") code)
                          (- acrobasic-indent-offset)
                        0)))))))))

(defun acrobasic-indent-line ()
  "Indent this line by the blocks that it is in.
Where a block ends, `acrc fmt' has the last word."
  (interactive)
  (let ((column (acrobasic--indentation)))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

;;;; Index

(defconst acrobasic--imenu
  '((nil "^[[:blank:]]*\\(?:[0-9]+[[:blank:]]*\\)?_[[:blank:]]*\\([[:alnum:]_]+\\)" 1)
    ("Programs" "^[[:blank:]]*\\(P\\(?:ROG\\|LC\\)[0-9]+\\)\\_>" 1)
    ("Aliases" "^[[:blank:]]*#[[:blank:]]*DEFINE[[:blank:]]*\\([[:alpha:]][[:alnum:]_]*\\)" 1))
  "Labels, programs and aliases.")

;;;; Projects and acrc

(defun acrobasic-project (folder)
  "The project of AcroBASIC that FOLDER lies in, for `project-find-functions'."
  (let ((root (locate-dominating-file folder "acrc.toml")))
    (cons 'transient (expand-file-name (or root folder)))))

(defun acrobasic--run (&rest arguments)
  "Run `acrc' with ARGUMENTS about this project in a compilation buffer."
  (let ((default-directory (cdr (acrobasic-project default-directory))))
    (compile (mapconcat #'shell-quote-argument (append (list acrobasic-acrc "--color" "never") arguments) " "))))

(defun acrobasic-lint ()
  "Check the project."
  (interactive)
  (acrobasic--run "lint" "--format" "concise"))

(defun acrobasic-sim ()
  "Run the project in virtual time."
  (interactive)
  (acrobasic--run "sim"))

(defun acrobasic-mem ()
  "Show where the memory of the controller goes."
  (interactive)
  (acrobasic--run "mem"))

(defun acrobasic-server (&optional _interactive)
  "The command line of the language server, for Eglot."
  (list acrobasic-acrc "lsp"))

(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs '(acrobasic-mode . acrobasic-server)))

;;;; The mode

(defvar acrobasic-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "C-c C-l") #'acrobasic-lint)
    (define-key map (kbd "C-c C-s") #'acrobasic-sim)
    (define-key map (kbd "C-c C-m") #'acrobasic-mem)
    map)
  "Keys of `acrobasic-mode'.")

;;;###autoload
(define-derived-mode acrobasic-mode prog-mode "AcroBASIC"
  "Major mode for programs of Parker ACR motion controllers.

\\{acrobasic-mode-map}"
  (setq-local comment-start "'"
              comment-start-skip "\\(?:['‘’]\\|\\<[Rr][Ee][Mm]\\>\\)[[:blank:]]*"
              comment-end ""
              indent-line-function #'acrobasic-indent-line
              indent-tabs-mode nil
              imenu-generic-expression acrobasic--imenu
              imenu-case-fold-search t
              syntax-propertize-function acrobasic--syntax-propertize
              font-lock-defaults '(acrobasic--font-lock-keywords nil t))
  (add-hook 'project-find-functions #'acrobasic-project nil t))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.8[Kk]\\'" . acrobasic-mode))

(provide 'acrobasic-mode)
;;; acrobasic-mode.el ends here
