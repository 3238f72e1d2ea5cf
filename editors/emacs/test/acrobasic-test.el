;;; acrobasic-test.el --- Tests of acrobasic-mode  -*- lexical-binding: t; -*-

;;; Commentary:

;; emacs -Q --batch -L .. -l acrobasic-test.el -f ert-run-tests-batch-and-exit, where the environment has ACRC, the program,
;; PROJECT, a folder to write to, and EXAMPLES, a folder with programs.

;;; Code:

(require 'ert)
(require 'package)
;; Debian's packages; from Emacs 29 on, Eglot is there without.
(add-to-list 'package-directory-list "/usr/share/emacs/site-lisp/elpa")
(package-initialize)
(require 'eglot)
(require 'imenu)
(require 'acrobasic-mode)

(defconst acrobasic-test-wait 20)

(defmacro acrobasic-test-with (text &rest body)
  "Run BODY in a buffer with TEXT."
  (declare (indent 1))
  `(with-temp-buffer
     (insert ,text)
     (acrobasic-mode)
     (font-lock-ensure)
     (goto-char (point-min))
     ,@body))

(defun acrobasic-test-face (text)
  "The face of the next TEXT."
  (let ((case-fold-search nil))
    (search-forward text)
    (get-text-property (match-beginning 0) 'face)))

(ert-deftest acrobasic-colours ()
  (acrobasic-test-with
      "10 PROGRAM\n_Start\nSET34 : jog vel X2\nPRINT \"it's REM\" : LV0 = SIN(P12288)\nGOTO Start\nREM isn't \"code\nSET 34 ' a \"\nPRINT \"open\nCLR 35\nSET_up = 3\n"
    (pcase-dolist (`(,text ,face)
                   '(("10" font-lock-constant-face) ("PROGRAM" font-lock-keyword-face) ("_Start" font-lock-constant-face)
                     ("SET" font-lock-builtin-face) ("jog" font-lock-builtin-face) ("PRINT" font-lock-builtin-face)
                     ("it" font-lock-string-face) ("REM" font-lock-string-face) ("LV" font-lock-variable-name-face)
                     ("SIN" font-lock-function-name-face) ("P" font-lock-variable-name-face)
                     ("GOTO" font-lock-keyword-face) ("Start" font-lock-constant-face)
                     ("isn" font-lock-comment-face) ("code" font-lock-comment-face) ("SET" font-lock-builtin-face)
                     ("a" font-lock-comment-face) ("open" font-lock-string-face) ("CLR" font-lock-builtin-face)
                     ("SET" nil)))
      (should (equal (list text face) (list text (acrobasic-test-face text)))))))

(ert-deftest acrobasic-indents ()
  (let ((text "PROGRAM\nFOR LV0 = 0 TO 3 STEP 1\n    'every (IF) row\n    IF (LV0 MOD 2 = 1)\n        SET 34\n    ELSE\n        PRINT \"IF (\"\n    ENDIF\n    IF (LV0) THEN SET 35\n    FOR LV1 = 0 TO 3 : SET LV1 : NEXT\nNEXT\nENDP\n"))
    (acrobasic-test-with (replace-regexp-in-string "^ +" "" text)
      (indent-region (point-min) (point-max))
      (should (equal (buffer-string) text)))))

(ert-deftest acrobasic-indents-examples ()
  (dolist (file (directory-files-recursively (expand-file-name (getenv "EXAMPLES")) "\\.8K\\'"))
    (with-temp-buffer
      (insert-file-contents file)
      (acrobasic-mode)
      (let ((text (buffer-string)))
        (indent-region (point-min) (point-max))
        (should (equal (buffer-string) text))))))

(ert-deftest acrobasic-comments ()
  (acrobasic-test-with "SET 34\nCLR 34\n"
    (comment-region (point-min) (point-max))
    (should (equal (buffer-string) "' SET 34\n' CLR 34\n"))
    (uncomment-region (point-min) (point-max))
    (should (equal (buffer-string) "SET 34\nCLR 34\n"))))

(ert-deftest acrobasic-index ()
  (acrobasic-test-with "#DEFINE Lamp BIT33\nPROGRAM\n_Start\n20 _Again\nENDP\n"
    (let ((index (imenu--make-index-alist t)))
      (should (assoc "Start" index))
      (should (assoc "Again" index))
      (should (assoc "Lamp" (assoc "Aliases" index))))))

;;;; A session with the server

(defun acrobasic-test-until (what condition)
  "Wait until CONDITION gives something; WHAT is waited for."
  (let ((deadline (+ (float-time) acrobasic-test-wait)) found)
    (while (not (or (setq found (funcall condition)) (> (float-time) deadline)))
      (accept-process-output nil 0.02))
    (or found (error "Waited in vain for %s" what))))

(defun acrobasic-test-findings (code)
  "Whether Flymake has a finding with CODE in this buffer."
  (seq-find (lambda (finding) (string-match-p code (flymake-diagnostic-text finding))) (flymake-diagnostics)))

(defun acrobasic-test-write (name text)
  "Write TEXT to the file NAME of the project."
  (let ((file (expand-file-name name (getenv "PROJECT"))))
    (make-directory (file-name-directory file) t)
    (let ((coding-system-for-write 'utf-8-unix))
      (write-region text nil file nil 'quiet))
    file))

(defun acrobasic-test-replace (old new)
  "Put NEW in the place of the first OLD of this buffer, and tell the server."
  (let ((case-fold-search nil))
    (goto-char (point-min))
    (search-forward old)
    (replace-match new t t))
  (eglot--signal-textDocument/didChange))

(ert-deftest acrobasic-session ()
  (acrobasic-test-write "acrc.toml" "[project]\nname = \"lamp\"\nfiles = [\"src/Setup.8K\", \"src/Prog0.8K\"]\n")
  (let* ((acrobasic-acrc (getenv "ACRC"))
         (eglot-autoshutdown nil)
         (eglot-confirm-server-initiated-edits nil)
         (setup (find-file-noselect
                 (acrobasic-test-write
                  "src/Setup.8K"
                  "' Größe 寸法 🙂\nSYS\nHALT ALL\nNEW ALL\nCLEAR\nDIM PROG0(4096)\nDIM DEF(10)\n#DEFINE Lamp BIT33\n")))
         (program (find-file-noselect
                   (acrobasic-test-write
                    "src/Prog0.8K"
                    "PROGRAM\n' läuft 🙂\n_Start\nSET Lamp : ' 🙂\nIF (LV9 = 1)\nCLR Lamp\nENDIF\nSET BIT34\nGOTO Strat\nENDP\n"))))
    (with-current-buffer program
      (should (eq major-mode 'acrobasic-mode))
      (apply #'eglot--connect (eglot--guess-contact))
      (acrobasic-test-until "the server" #'eglot-current-server)
      ;; What a command loop would do by itself.
      (flymake-start)
      (acrobasic-test-until "the unknown label" (lambda () (acrobasic-test-findings "Strat")))
      ;; What is edited is seen.
      (acrobasic-test-replace "Strat" "Start")
      (acrobasic-test-until "no unknown label" (lambda () (not (acrobasic-test-findings "Strat"))))
      ;; Completion.
      (acrobasic-test-replace "SET Lamp" "SET Lam")
      (pcase-let ((`(,start ,end ,table . ,_) (eglot-completion-at-point)))
        (should (member "Lamp" (all-completions (buffer-substring-no-properties start end) table))))
      (acrobasic-test-replace "SET Lam" "SET Lamp")
      ;; Hover.
      (goto-char (point-min))
      (search-forward "SET La")
      (should (string-match-p "BIT33" (format "%s" (jsonrpc-request (eglot-current-server) :textDocument/hover
                                                                    (eglot--TextDocumentPositionParams)))))
      ;; Rename across files.
      (eglot-rename "Lampe")
      (should (equal (buffer-string)
                     "PROGRAM\n' läuft 🙂\n_Start\nSET Lampe : ' 🙂\nIF (LV9 = 1)\nCLR Lampe\nENDIF\nSET BIT34\nGOTO Start\nENDP\n"))
      (with-current-buffer setup
        (should (string-match-p "#DEFINE Lampe BIT33" (buffer-string)))
        (eglot--signal-textDocument/didChange))
      ;; Formatting.
      (eglot-format-buffer)
      (should (string-match-p "^ +CLR Lampe$" (buffer-string)))
      ;; A repair.
      (goto-char (point-min))
      (search-forward "SET BIT34")
      (eglot--signal-textDocument/didChange)
      (let* ((actions (append (jsonrpc-request
                               (eglot-current-server) :textDocument/codeAction
                               (list :textDocument (eglot--TextDocumentIdentifier)
                                     :range (list :start (eglot--pos-to-lsp-position (1- (point)))
                                                  :end (eglot--pos-to-lsp-position (1- (point))))
                                     :context (list :diagnostics [])))
                              nil))
             (alias (seq-find (lambda (action) (string-match-p "alias" (downcase (plist-get action :title)))) actions)))
        (should alias)
        (eglot--apply-workspace-edit (plist-get alias :edit))
        (should-not (string-match-p "SET BIT34" (buffer-string))))
      (eglot-shutdown (eglot-current-server)))
    (dolist (buffer (list setup program))
      (with-current-buffer buffer (set-buffer-modified-p nil))
      (kill-buffer buffer))))

(ert-deftest acrobasic-compilation-finds-places ()
  (let* ((acrobasic-acrc (getenv "ACRC"))
         (file (acrobasic-test-write "single/Prog0.8K" "PROGRAM\nGOTO Nowhere\nENDP\n"))
         (default-directory (file-name-directory file)))
    (acrobasic-lint)
    (let ((buffer (get-buffer "*compilation*")))
      (acrobasic-test-until "the end" (lambda () (not (process-live-p (get-buffer-process buffer)))))
      (with-current-buffer buffer
        (compilation--ensure-parse (point-max))
        (goto-char (point-min))
        (compilation-next-error 1)
        (let ((message (get-text-property (point) 'compilation-message)))
          (should (equal 2 (cadr (compilation--message->loc message)))))))))

(provide 'acrobasic-test)
;;; acrobasic-test.el ends here
