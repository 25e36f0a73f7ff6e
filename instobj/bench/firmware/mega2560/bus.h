/* I2C bus: transfers that end in time, and recovery of a bus that hangs. */
#pragma once
#include <stdbool.h>
#include <stdint.h>

extern uint16_t bus_errors;      /* transfers without an answer, or broken off */
extern uint16_t bus_recoveries;  /* times that the bus hung and was freed */

/* `recovered` is called after each recovery; stuck: the data line is still held low. */
void bus_start(void (*recovered)(bool stuck));

/* Write `out`, then read `in` after a repeated start; false where a byte was not acknowledged. */
bool bus_transfer(uint8_t address, const uint8_t *out, uint8_t out_count, uint8_t *in, uint8_t in_count);
