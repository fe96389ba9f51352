// The page's words in the chosen language; numbers and plurals as that language writes them.
import { computed, effect, signal } from "@preact/signals";
import { de } from "./de";
import { en, type WordKey, type Words } from "./en";
import { es } from "./es";
import { zh } from "./zh";

export const LANGUAGES = { en: "English", de: "Deutsch", es: "Español", zh: "中文" } as const;
export type Language = keyof typeof LANGUAGES;

const CATALOGUE: Record<Language, Words> = { en, de, es, zh };
const KEPT = "sitewright-language";

export const language = signal<Language>(firstLanguage());
effect(() => {
  document.documentElement.lang = language.value;
});

const plurals = computed(() => new Intl.PluralRules(language.value));

function isLanguage(name: string | null | undefined): name is Language {
  return name != null && name in LANGUAGES;
}

function firstLanguage(): Language {
  const asked = new URLSearchParams(location.search).get("lang");
  const wishes = [asked, localStorage.getItem(KEPT), ...navigator.languages.map((name) => name.slice(0, 2))];
  return wishes.find(isLanguage) ?? "en";
}

export function chooseLanguage(name: Language): void {
  localStorage.setItem(KEPT, name);
  language.value = name;
}

/** Returns a sentence with its places filled. */
export function say(key: WordKey, values: Readonly<Record<string, string | number>> = {}): string {
  return CATALOGUE[language.value][key].replace(/\{(\w+)\}/g, (place, name: string) => {
    const value = values[name];
    return value === undefined ? place : String(value);
  });
}

/** Returns a sentence in the plural form that fits a number; `key` has forms `.one` and `.other`. */
export function sayCount(key: "act.all.note" | "plan.steps" | "health.clients", count: number): string {
  const form = plurals.value.select(count) === "one" ? "one" : "other";
  return say(`${key}.${form}`, { count: inNumbers(count) });
}

/** Returns a sentence by a key that comes from the server; the word itself if the page has none. */
export function sayWord(prefix: string, word: string): string {
  const key = `${prefix}.${word}`;
  return key in CATALOGUE.en ? say(key as WordKey) : word;
}

export function inNumbers(value: number, digits = 0): string {
  return new Intl.NumberFormat(language.value, { maximumFractionDigits: digits, minimumFractionDigits: digits }).format(value);
}

export function inSeconds(value: number): string {
  return `${inNumbers(value, value < 10 && value > 0 ? 1 : 0)} s`;
}

export function inMillimetres(value_m: number): string {
  return inNumbers(value_m * 1000);
}

export function atTime(ms: number): string {
  const place = language.value === "en" ? "en-GB" : language.value; // day before month, 24 hours
  return new Intl.DateTimeFormat(place, { dateStyle: "short", timeStyle: "medium" }).format(ms);
}
