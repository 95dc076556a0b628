/* SPDX-License-Identifier: MIT */
/*
 * Symbol tables; see symbol.h.
 */
#include "symbol.h"

#include "token.h"

#include <string.h>

void symbols_init(struct symbols *s, struct names *names, struct arena *arena)
{
	*s = (struct symbols){ .names = names, .arena = arena, .table = SYMBOL_GLOBAL };
}

bool symbols_push(struct symbols *s)
{
	if (s->table + 1 == SYMBOL_TABLES)
		return false;
	s->first[++s->table] = NULL;
	return true;
}

/* Takes a symbol out of the chain of those of its name. */
static void unbind(struct symbols *s, struct symbol *symbol)
{
	struct symbol **link = &s->names->list[symbol->name].binding;
	while (*link != symbol)
		link = &(*link)->hidden;
	*link = symbol->hidden;
	symbol->table = 0;
}

static void retire(struct symbols *s, struct symbol *symbol)
{
	symbol->next = s->dying;
	s->dying = symbol;
}

void symbols_pop(struct symbols *s)
{
	struct symbol *next;
	for (struct symbol *symbol = s->first[s->table]; symbol; symbol = next) {
		next = symbol->next;
		if (symbol->table)
			unbind(s, symbol);
		symbol->orphan = symbol->kept;
		if (!symbol->kept)
			retire(s, symbol);
	}
	s->first[s->table--] = NULL;
}

void symbols_recycle(struct symbols *s, size_t token_count)
{
	s->round = token_count / SYMBOL_ROUND;
	while (s->dead) {
		struct symbol *symbol = s->dead;
		s->dead = symbol->next;
		if (symbol->kept)
			continue;
		symbol->next = s->unused;
		s->unused = symbol;
	}
	s->dead = s->dying;
	s->dying = NULL;
}

struct symbol *symbol_find(const struct symbols *s, uint32_t name)
{
	return s->names->list[name].binding;
}

static struct symbol *fresh(struct symbols *s)
{
	struct symbol *symbol = s->unused;
	if (!symbol)
		return ARENA_NEW(s->arena, struct symbol);
	s->unused = symbol->next;
	return symbol;
}

struct symbol *symbol_create(struct symbols *s, uint32_t name, unsigned table)
{
	struct symbol *symbol = fresh(s);
	*symbol = (struct symbol){
		.text = s->names->list[name].text,
		.name = name,
		.table = table,
		.next = s->first[table],
	};
	symbol->slot = &symbol->value;
	s->first[table] = symbol;
	struct symbol **link = &s->names->list[name].binding;
	while (*link && (*link)->table > table)
		link = &(*link)->hidden;
	symbol->hidden = *link;
	*link = symbol;
	return symbol;
}

struct symbol *symbol_of_element(struct symbols *s, const struct symbol *array, struct value *slot)
{
	struct symbol *symbol = fresh(s);
	*symbol = (struct symbol){
		.slot = slot,
		.text = array->text,
		.name = array->name,
		.table = array->table,
		.kept = slot->kind == VALUE_ARRAY,
		.next = s->dying,
	};
	s->dying = symbol;
	return symbol;
}

void symbol_remove(struct symbols *s, struct symbol *symbol)
{
	unbind(s, symbol); /* it stays in the list of its table for now */
	s->removed++;
}

void symbol_let_go(struct symbols *s, struct symbol *symbol, bool kept_before)
{
	symbol->kept = kept_before;
	if (symbol->orphan && !kept_before)
		retire(s, symbol);
}

void symbols_drop_removed(struct symbols *s)
{
	s->removed = 0;
	for (unsigned table = SYMBOL_GLOBAL; table <= s->table; table++) {
		struct symbol **link = &s->first[table];
		for (struct symbol *symbol; (symbol = *link) != NULL;) {
			if (symbol->table) {
				link = &symbol->next;
				continue;
			}
			*link = symbol->next;
			symbol->next = s->unused;
			s->unused = symbol;
		}
	}
}

const struct value *symbol_value(const struct symbol *symbol)
{
	return symbol->slot;
}

const char *symbol_name(const struct symbol *symbol)
{
	return symbol->text;
}

bool array_accepts(struct array *a, const struct value *v)
{
	const unsigned terms = v->kind == VALUE_NUMBER ? v->number.terms : 0;
	const int token = v->kind == VALUE_NODE ? v->token : 0;
	if (a->kind == VALUE_NONE) {
		a->kind = v->kind;
		a->token = token;
		a->terms = terms;
	}
	return a->kind == v->kind && a->token == token && a->terms == terms;
}
