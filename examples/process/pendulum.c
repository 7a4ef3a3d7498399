/* A controller in C: swings a pendulum up by its energy and catches it at the top.
 *
 *     cc -O2 -o pendulum pendulum.c -lm
 *
 * It speaks the protocol of docs/process-protocol.md with nothing but the standard library: messages come one a line,
 * without blanks, their keys in a fixed order, so that looking for a key is reading it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_LINE = 65536 };

/* The limits of the torque, N m, and what swings and catches; the pendulum has 1 kg and 1 m. */
static const double LARGEST = 2.0, UPRIGHT_ENERGY = 5.0, SWING = 1.0, STIFFNESS = 12.0, DAMPING = 2.5, CATCH_RAD = 0.4;

/* The text behind a key, or NULL where the message has no such key. */
static const char *after(const char *message, const char *key)
{
    const char *found = strstr(message, key);
    return found ? found + strlen(key) : NULL;
}

static double torque(double angle_rad, double speed_radps)
{
    double energy = speed_radps * speed_radps / 6.0 + UPRIGHT_ENERGY * cos(angle_rad);
    double wanted = fabs(angle_rad) < CATCH_RAD ? -STIFFNESS * angle_rad - DAMPING * speed_radps
                                                : SWING * (UPRIGHT_ENERGY - energy) * (speed_radps < 0 ? -1 : 1);
    return fmax(-LARGEST, fmin(LARGEST, wanted));
}

static int decide(const char *message)
{
    const char *number = after(message, "\"number\":"), *seen = after(message, "\"observation\":[");
    char *rest;
    if (!number || !seen) {
        fprintf(stderr, "expected a number and an observation of three numbers\n");
        return EXIT_FAILURE;
    }
    double cosine = strtod(seen, &rest);
    double sine = strtod(rest + 1, &rest);
    double speed = strtod(rest + 1, &rest);
    double angle = atan2(sine, cosine);
    printf("{\"type\":\"action\",\"number\":%ld,\"action\":{\"torque\":%.6f},\"situation\":\"%s\"}\n",
           strtol(number, NULL, 10), torque(angle, speed), fabs(angle) < CATCH_RAD ? "catching" : "swinging");
    return EXIT_SUCCESS;
}

int main(void)
{
    static char message[LONGEST_LINE];
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); /* an answer goes out with its line */
    while (fgets(message, sizeof message, stdin)) {
        if (after(message, "{\"type\":\"hello\""))
            puts("{\"type\":\"hello\",\"protocol\":1}");
        else if (after(message, "{\"type\":\"decide\"") && decide(message) != EXIT_SUCCESS)
            return EXIT_FAILURE;
    }
    return EXIT_SUCCESS; /* the end of the input: whoever asked is gone */
}
