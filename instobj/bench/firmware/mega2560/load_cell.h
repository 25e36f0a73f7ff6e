/* The load cell: an HX711 or a voltage, read by interrupts; its lines wait until there is time for them. */
#pragma once
#include <stdint.h>

#include "plan.h"

#ifdef LOAD_CELL
void load_start(void);
void load_tick(uint32_t now_ms); /* call every millisecond, from the clock's interrupt */
void load_send(void);            /* lines of all readings since the last call */
void load_pause(void);           /* leave the analogue converter to others */
void load_resume(void);
#else
static inline void load_start(void) {}
static inline void load_tick(uint32_t now_ms) { (void)now_ms; }
static inline void load_send(void) {}
static inline void load_pause(void) {}
static inline void load_resume(void) {}
#endif
