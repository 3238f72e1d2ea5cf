/*
 * What a word is that the language does not know, and where a string ends.
 *
 * A name is an alias, an axis or a variable of the next statement, depending on what stands around it: `VEL Fast` sets a
 * speed, `VEL X5` reports it and moves X, `VEL Fast = 5` reports it and assigns. The rules are those of the reader in
 * `crates/acrc-syntax/src/reader`.
 */

#include "tree_sitter/parser.h"
#include "words.h"

#include <string.h>

enum TokenType {
    NAME,
    LONG_NAME,
    FLAG_NAME,
    ASSIGNED_NAME,
    AXIS,
    AXIS_WITH_TARGET,
    STRING,
    THEN,
    REMARK_TEXT,
    DAUGHTER_MAY_FOLLOW,
    ITEM_MAY_FOLLOW,
    ERROR_SENTINEL,
};

// Letters that an axis name may have.
enum { MAX_AXIS_NAME = 4 };
// No word of the language is longer.
enum { LONGEST_WORD = 15 };

static bool is_letter(int32_t c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
static bool is_digit(int32_t c) { return c >= '0' && c <= '9'; }
static bool is_line_end(int32_t c) { return c == '\n' || c == '\r'; }

static bool is_blank(int32_t c) {
    return c == ' ' || c == '\t' || c == '\f' || c == 0xA0 || c == 0x2007 || c == 0x202F;
}

static bool is_sign(int32_t c) { return c == '+' || c == '-' || (c >= 0x2010 && c <= 0x2014) || c == 0x2212; }

static bool is_curly_quote(int32_t c) { return c == 0x201C || c == 0x201D || c == 0x201E; }

static bool contains(const char *const *words, size_t count, const char *word) {
    for (size_t low = 0, high = count; low < high;) {
        size_t middle = low + (high - low) / 2;
        int order = strcmp(words[middle], word);
        if (order == 0) return true;
        if (order < 0) low = middle + 1;
        else high = middle;
    }
    return false;
}

#define CONTAINS(words, word) contains(words, sizeof(words) / sizeof(*(words)), word)

static bool is_reserved(const char *word) { return CONTAINS(RESERVED, word); }

static void advance(TSLexer *lexer) { lexer->advance(lexer, false); }

static bool give(TSLexer *lexer, enum TokenType type) {
    lexer->result_symbol = (TSSymbol)type;
    return true;
}

/*
 * A straight opening quote is closed by a straight one if the line has one, so that curly quotes may stand in a text; text
 * copied from a document mixes them, and then any quote closes. Without a closing quote the line's end closes.
 */
static bool scan_string(TSLexer *lexer) {
    bool straight = lexer->lookahead == '"';
    bool closed = false;
    advance(lexer);
    while (!lexer->eof(lexer) && !is_line_end(lexer->lookahead)) {
        int32_t c = lexer->lookahead;
        advance(lexer);
        if (c == '"' || (is_curly_quote(c) && !straight)) {
            lexer->mark_end(lexer);
            return give(lexer, STRING);
        }
        if (is_curly_quote(c) && !closed) {
            lexer->mark_end(lexer);
            closed = true;
        }
    }
    if (!closed) lexer->mark_end(lexer);
    return give(lexer, STRING);
}

/* What follows a name on its line. */
typedef struct {
    bool assigned;
    bool target;
} Ahead;

static Ahead look_ahead(TSLexer *lexer) {
    while (is_blank(lexer->lookahead)) advance(lexer);
    int32_t c = lexer->lookahead;
    Ahead ahead = {c == '=', is_digit(c) || is_sign(c) || c == '/' || c == '('};
    if (c == '.') {
        advance(lexer);
        ahead.target = is_digit(lexer->lookahead);
    }
    return ahead;
}

/*
 * The token is the letters of the word; digits and underscores that belong to a name are taken by the grammar, because an
 * axis has none and where the token ends has to be said before it is known what it is.
 */
static bool scan_name(TSLexer *lexer, const bool *valid, unsigned letters) {
    bool is_short = letters <= MAX_AXIS_NAME;
    bool touches_target = is_digit(lexer->lookahead);
    while (is_letter(lexer->lookahead) || is_digit(lexer->lookahead) || lexer->lookahead == '_') advance(lexer);
    Ahead ahead = look_ahead(lexer);
    if (!valid[ITEM_MAY_FOLLOW]) {
        if (valid[ASSIGNED_NAME] && ahead.assigned) return give(lexer, ASSIGNED_NAME);
        if (valid[FLAG_NAME]) return give(lexer, FLAG_NAME);
        if (valid[AXIS_WITH_TARGET] && is_short && (touches_target || ahead.target)) return give(lexer, AXIS_WITH_TARGET);
    }
    if (valid[NAME]) return give(lexer, NAME);
    if (valid[AXIS] && is_short) return give(lexer, AXIS);
    if (valid[LONG_NAME] && !is_short) return give(lexer, LONG_NAME);
    return false;
}

static bool scan_remark(TSLexer *lexer) {
    if (lexer->eof(lexer) || is_line_end(lexer->lookahead)) return false;
    while (!lexer->eof(lexer) && !is_line_end(lexer->lookahead)) advance(lexer);
    lexer->mark_end(lexer);
    return give(lexer, REMARK_TEXT);
}

static bool scan_word(TSLexer *lexer, const bool *valid) {
    char word[LONGEST_WORD + 2] = {0};
    unsigned letters = 0;
    bool in_recovery = valid[ERROR_SENTINEL];
    for (; is_letter(lexer->lookahead); letters++) {
        if (letters < LONGEST_WORD) word[letters] = (char)(lexer->lookahead & ~0x20);
        advance(lexer);
        if (letters == 3 && valid[THEN] && !in_recovery && strcmp(word, "THEN") == 0) {
            lexer->mark_end(lexer);
            return give(lexer, THEN);
        }
    }
    lexer->mark_end(lexer);
    if (letters <= LONGEST_WORD) {
        if (is_reserved(word)) return false;
        if (valid[DAUGHTER_MAY_FOLLOW] && CONTAINS(DAUGHTERS, word)) return false;
        if (lexer->lookahead == '$') {
            word[letters] = '$';
            if (is_reserved(word)) return false;
        }
    }
    if (in_recovery) return give(lexer, NAME);
    return scan_name(lexer, valid, letters);
}

void *tree_sitter_acrobasic_external_scanner_create(void) { return NULL; }

void tree_sitter_acrobasic_external_scanner_destroy(void *payload) { (void)payload; }

unsigned tree_sitter_acrobasic_external_scanner_serialize(void *payload, char *buffer) {
    (void)payload;
    (void)buffer;
    return 0;
}

void tree_sitter_acrobasic_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
    (void)payload;
    (void)buffer;
    (void)length;
}

bool tree_sitter_acrobasic_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
    (void)payload;
    while (is_blank(lexer->lookahead)) lexer->advance(lexer, true);
    int32_t c = lexer->lookahead;
    if (valid[REMARK_TEXT] && !valid[ERROR_SENTINEL]) return scan_remark(lexer);
    if (valid[STRING] && (c == '"' || is_curly_quote(c))) return scan_string(lexer);
    if (is_letter(c)) return scan_word(lexer, valid);
    return false;
}
