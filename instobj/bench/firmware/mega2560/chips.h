/* Sensors of the object: started, read, and started anew where one was lost. */
#pragma once
#include <stdbool.h>
#include <stdint.h>

enum { TEMPERATURE, X, Y, Z, VALUES };

/* Of a kind of sensor (tmag5273.c, mlx90393.c or tle493d.c). */
bool chip_move(uint8_t from, uint8_t to);              /* to another address until power is lost */
bool chip_setup(uint8_t address);                      /* range, averaging, temperature, free running */
bool chip_read(uint8_t address, int16_t values[VALUES]);
bool chip_undervoltage(uint8_t address);               /* since the last call */
int16_t chip_decidegrees(int16_t temperature);         /* of its temperature reading, 0.1 degrees C */

extern uint16_t supply_errors; /* times that a chip saw too low a voltage */

void chips_start(void);
bool chips_read(uint8_t number, int16_t values[VALUES]); /* false: silent */
void chips_watch(void);                                  /* call once a second */
void chips_after_recovery(bool stuck);
