#include "options/completion.h"

#include <string.h>

#include "options/option.h"

enum { SHORT_LEAST = 10 /* letters of a meaning that tells something */ };

/* Common parts ------------------------------------------------------------------------------------------------------*/

/* True if the word, of `length` letters, is one of those before it. */
static bool is_repeated(const char *words, const char *word, size_t length) {
    for (const char *at = words; at < word;) {
        size_t own = strcspn(at, "|,");
        if (own == length && strncmp(at, word, length) == 0)
            return true;
        at += own + 1;
    }
    return false;
}

/* Adds words that are separated by | or , with `before` each, and each once. */
static void add_words(Text *text, const char *words, const char *before) {
    for (const char *at = words; *at;) {
        size_t length = strcspn(at, "|,");
        if (!is_repeated(words, at, length))
            text_format(text, "%s%.*s", before, (int)length, at);
        at += length + (at[length] != '\0');
    }
}

/* Adds the beginning of a meaning that fits a list, quoted for all three shells; what goes before a colon
 * only says to what the rest applies. */
static void add_short(Text *text, const char *meaning) {
    size_t from = strcspn(meaning, ";:(.\n`");
    const char *stops = meaning[from] == '(' && from < SHORT_LEAST ? ";:.\n`" : ";:(.\n`";
    from = meaning[from] == ':' ? from + 1 : 0;
    size_t length = from + strcspn(meaning + from, stops);
    if (meaning[length] == '.' && meaning[length + 1] && meaning[length + 1] != ' ')
        length += 1 + strcspn(meaning + length + 1, ";:(\n`"); /* a name with a point */
    for (size_t i = length; i-- > 0 && meaning[i] != ')';)
        length = meaning[i] == '(' ? i : length; /* a bracket that would stay open */
    while (length && meaning[length - 1] == ' ')
        length--;
    for (size_t i = 0; i < length; i++)
        if (!strchr("'\"[]\\$", meaning[i]))
            text_format(text, "%c", meaning[i]);
}

static bool has_files(const Option *option) {
    return option->kind == OPTION_FILE || option->kind == OPTION_FOLDER;
}

/* bash --------------------------------------------------------------------------------------------------------------*/

static const char bash_begin[] =
    "# Completion of clearance for bash, made by: clearance schema completion bash\n"
    "\n"
    "# _clearance_files ENDING ...: files with one of these endings, and directories\n"
    "_clearance_files() {\n"
    "    local ending\n"
    "    compopt -o filenames 2>/dev/null\n"
    "    mapfile -t COMPREPLY < <(\n"
    "        compgen -d -- \"$cur\"\n"
    "        for ending in \"$@\"; do\n"
    "            compgen -f -X \"!*$ending\" -- \"$cur\"\n"
    "        done\n"
    "    )\n"
    "}\n"
    "\n"
    "# _clearance_words WORD ...\n"
    "_clearance_words() {\n"
    "    mapfile -t COMPREPLY < <(compgen -W \"$*\" -- \"$cur\")\n"
    "}\n"
    "\n"
    "# The names of parameters of the first file on the line.\n"
    "_clearance_names() {\n"
    "    local word\n"
    "    for word in \"${COMP_WORDS[@]:2}\"; do\n"
    "        word=${word//\\\\/}\n"
    "        [ -f \"$word\" ] || continue\n"
    "        compopt -o nospace 2>/dev/null\n"
    "        _clearance_words \"$(\"${COMP_WORDS[0]}\" schema names \"$word\" 2>/dev/null | cut -f 1)\"\n"
    "        COMPREPLY=(\"${COMPREPLY[@]/%/=}\")\n"
    "        return\n"
    "    done\n"
    "}\n"
    "\n"
    "_clearance() {\n"
    "    local cur=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} verb=${COMP_WORDS[1]}\n"
    "    COMPREPLY=()\n"
    "    case $verb:$previous in\n";

static void add_bash_value(Text *text, VerbId verb, const Option *option) {
    text_format(text, "    %s:%s)\n        ", verb_rows[verb].name, option->name);
    if (option->kind == OPTION_NAME) {
        text_add(text, "_clearance_names");
    } else if (has_files(option)) {
        text_add(text, "_clearance_files");
        add_words(text, option->words ? option->words : "", " ");
        text_add(text, option->kind == OPTION_FILE && !option->words ? " ''" : "");
    } else {
        text_add(text, option->words ? "_clearance_words" : ":");
        add_words(text, option->words ? option->words : "", " ");
    }
    text_add(text, "\n        return ;;\n");
}

static void add_bash_verb(Text *text, VerbId verb) {
    const Verb *row = &verb_rows[verb];
    const char *names[OPTIONS_MOST];
    size_t count = option_names(verb, names);
    text_format(text, "    %s:-*)\n        _clearance_words", row->name);
    for (size_t n = 0; n < count; n++)
        text_format(text, " %s", names[n]);
    text_format(text, " --help ;;\n    %s:*)\n        ", row->name);
    text_add(text, *row->words ? "_clearance_words" : *row->endings ? "_clearance_files" : ":");
    add_words(text, *row->words ? row->words : row->endings, " ");
    text_add(text, " ;;\n");
}

static void add_bash(Text *text) {
    text_add(text, bash_begin);
    for (VerbId verb = 0; verb < VERBS; verb++)
        for (size_t o = 0; o < option_count; o++)
            if (option_rows[o].verbs >> verb & 1 && option_rows[o].argument && option_rows[o].kind != OPTION_MAYBE)
                add_bash_value(text, verb, &option_rows[o]);
    text_add(text, "    schema:names)\n        _clearance_files .json\n        return ;;\n"
                   "    schema:completion)\n        _clearance_words");
    add_words(text, COMPLETION_SHELLS, " ");
    text_add(text, "\n        return ;;\n    esac\n"
                   "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
                   "        _clearance_files .json\n"
                   "        mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(compgen -W \"");
    for (VerbId verb = 0; verb < VERBS; verb++)
        text_format(text, "%s ", verb_rows[verb].name);
    text_add(text, "--help --version\" -- \"$cur\")\n        return\n    fi\n    case $verb:$cur in\n");
    for (VerbId verb = 0; verb < VERBS; verb++)
        add_bash_verb(text, verb);
    text_add(text, "    esac\n}\n\ncomplete -F _clearance clearance\n");
}

/* zsh ---------------------------------------------------------------------------------------------------------------*/

static const char zsh_begin[] =
    "#compdef clearance\n"
    "# Completion of clearance for zsh, made by: clearance schema completion zsh\n"
    "\n"
    "# The names of parameters of the first file on the line.\n"
    "_clearance_names() {\n"
    "  local word\n"
    "  local -a names\n"
    "  for word in ${(Q)words[2,-1]}; do\n"
    "    [[ -f $word ]] || continue\n"
    "    names=(${(f)\"$($_clearance_program schema names $word 2>/dev/null | cut -f 1)\"})\n"
    "    compadd -S = -a names\n"
    "    return\n"
    "  done\n"
    "}\n"
    "\n"
    "_clearance() {\n"
    "  local _clearance_program=$words[1]\n"
    "  local -a verbs\n"
    "  verbs=(\n";

/* Adds the endings as patterns of files: *.mp4 *.mkv */
static void add_zsh_files(Text *text, const char *endings) {
    text_add(text, "_files");
    if (!*endings)
        return;
    text_add(text, " -g \"");
    for (const char *at = endings; *at;) {
        size_t length = strcspn(at, ",");
        text_format(text, "%s*%.*s", at == endings ? "" : " ", (int)length, at);
        at += length + (at[length] != '\0');
    }
    text_add(text, "\"");
}

static void add_zsh_option(Text *text, const Option *option) {
    text_format(text, " \\\n      '*%s[", option->name);
    add_short(text, option->help);
    text_add(text, "]");
    if (option->argument && option->kind != OPTION_MAYBE) {
        text_add(text, ":value:");
        if (option->kind == OPTION_NAME) {
            text_add(text, "_clearance_names");
        } else if (option->kind == OPTION_FOLDER) {
            text_add(text, "_files -/");
        } else if (option->kind == OPTION_FILE) {
            add_zsh_files(text, option->words ? option->words : "");
        } else if (option->words) {
            text_add(text, "(");
            add_words(text, option->words, " ");
            text_add(text, ")");
        }
    }
    text_add(text, "'");
}

static void add_zsh(Text *text) {
    text_add(text, zsh_begin);
    for (VerbId verb = 0; verb < VERBS; verb++) {
        text_format(text, "    '%s:", verb_rows[verb].name);
        add_short(text, verb_rows[verb].meaning);
        text_add(text, "'\n");
    }
    text_add(text, "  )\n"
                   "  if (( CURRENT == 2 )); then\n"
                   "    _describe verb verbs\n"
                   "    _files -g \"*.json\"\n"
                   "    return\n"
                   "  fi\n"
                   "  shift words\n"
                   "  (( CURRENT-- ))\n"
                   "  case $words[1] in\n");
    for (VerbId verb = 0; verb < VERBS; verb++) {
        const Verb *row = &verb_rows[verb];
        text_format(text, "  %s)\n    _arguments", row->name);
        for (size_t o = 0; o < option_count; o++)
            if (option_rows[o].verbs >> verb & 1)
                add_zsh_option(text, &option_rows[o]);
        text_add(text, " \\\n      '--help[list the options]' \\\n      '*:file:");
        if (*row->words) {
            text_add(text, "(");
            add_words(text, row->words, " ");
            text_add(text, ")");
        } else if (*row->endings) {
            add_zsh_files(text, row->endings);
        }
        text_add(text, "' ;;\n");
    }
    text_add(text, "  esac\n}\n\n_clearance \"$@\"\n");
}

/* fish --------------------------------------------------------------------------------------------------------------*/

static const char fish_begin[] =
    "# Completion of clearance for fish, made by: clearance schema completion fish\n"
    "\n"
    "# The names of parameters of the first file on the line.\n"
    "function __clearance_names\n"
    "    set -l words (commandline -opc)\n"
    "    for word in $words[3..-1]\n"
    "        if test -f $word\n"
    "            $words[1] schema names $word 2>/dev/null | string replace \\t =\\t\n"
    "            return\n"
    "        end\n"
    "    end\n"
    "end\n"
    "\n"
    "complete -c clearance -f\n"
    "complete -c clearance -n __fish_use_subcommand -k -a '(__fish_complete_suffix .json)'\n"
    "complete -c clearance -l help -d 'list the options'\n";

static void add_fish_files(Text *text, const char *endings) {
    text_add(text, " -k -a '(__fish_complete_suffix");
    add_words(text, endings, " ");
    text_add(text, ")'");
}

static void add_fish_option(Text *text, VerbId verb, const Option *option) {
    text_format(text, "complete -c clearance -n '__fish_seen_subcommand_from %s' -l %s", verb_rows[verb].name,
                option->name + 2);
    text_add(text, option->argument && option->kind != OPTION_MAYBE ? " -x" : "");
    if (option->kind == OPTION_NAME) {
        text_add(text, " -a '(__clearance_names)'");
    } else if (option->kind == OPTION_FOLDER) {
        text_add(text, " -a '(__fish_complete_directories)'");
    } else if (option->kind == OPTION_FILE) {
        add_fish_files(text, option->words ? option->words : "''");
    } else if (option->words) {
        text_add(text, " -a '");
        add_words(text, option->words, " ");
        text_add(text, "'");
    }
    text_add(text, " -d '");
    add_short(text, option->help);
    text_add(text, "'\n");
}

static void add_fish(Text *text) {
    text_add(text, fish_begin);
    for (VerbId verb = 0; verb < VERBS; verb++) {
        const Verb *row = &verb_rows[verb];
        text_format(text, "complete -c clearance -n __fish_use_subcommand -a %s -d '", row->name);
        add_short(text, row->meaning);
        text_format(text, "'\ncomplete -c clearance -n '__fish_seen_subcommand_from %s'", row->name);
        if (*row->words) {
            text_add(text, " -a '");
            add_words(text, row->words, " ");
            text_add(text, "'");
        } else {
            add_fish_files(text, row->endings);
        }
        text_add(text, "\n");
        for (size_t o = 0; o < option_count; o++)
            if (option_rows[o].verbs >> verb & 1)
                add_fish_option(text, verb, &option_rows[o]);
    }
}

bool completion_add(Text *text, const char *shell) {
    if (strcmp(shell, "bash") == 0)
        add_bash(text);
    else if (strcmp(shell, "zsh") == 0)
        add_zsh(text);
    else if (strcmp(shell, "fish") == 0)
        add_fish(text);
    else
        return false;
    return true;
}
